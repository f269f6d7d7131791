package org.robotui.uic.alerts.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertWords;
import org.robotui.ui.Health;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;

/** What is seen of the view while it is shown: a line of controls, and the list. Display thread. */
final class AlertsSurface implements ViewSurface {
  private static final long HOUR = 60;
  private static final Optional<Long> ENDLESS = Optional.empty();
  private static final Optional<Long> HEARD = Optional.of(0L);

  private final UiContext context;
  private final AlertActions hands;
  private final AlertWords words;
  private final Composite root;
  private final QuietButton muteAll;
  private final QuietButton acknowledge;
  private final Composite bar;
  private final RowTable<Alert> table;
  private final FilterField filter;
  private final QuietButton historyButton;
  private final EventColumns eventColumns;
  private final RowTable<AlertEvent> events;
  private boolean history;
  private Page page = new Page(List.of(), Optional.empty(), 0, List.of());

  AlertsSurface(Composite parent, UiContext context, AlertActions hands, AlertWords words) {
    this.context = context;
    this.hands = hands;
    this.words = words;
    this.root = Boxes.root(parent, context.theme(), this::focus);
    this.bar = Boxes.bar(root, context.theme(), 4);
    this.muteAll = new QuietButton(bar, context.theme(), this::pressMute).text("Mute all");
    muteAll.setLayoutData(Boxes.middle());
    this.acknowledge =
        new QuietButton(bar, context.theme(), () -> hands.acknowledge(page.alerts())).text("Acknowledge all")
            .hint("Acknowledges all: they are silent, and are removed when they are over");
    acknowledge.setLayoutData(Boxes.middle());
    this.filter = new FilterField(bar, context.theme(), "Filter the history", typed -> showEvents());
    filter.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    this.historyButton = new QuietButton(bar, context.theme(), this::turn).text("History")
        .hint("Shows what happened, also in earlier runs (H)");
    historyButton.setLayoutData(new GridData(SWT.END, SWT.CENTER, true, false));
    this.table = new RowTable<>(root, context.theme(), new AlertColumns(words).all(), Alert::id);
    table.control().setLayoutData(Boxes.fill());
    table.list().named("Alerts").several().onOpen(alert -> hands.acknowledge(List.of(alert))).menu(this::menu);
    table.onOrder(() -> table.show(table.sorted(page.alerts())));
    table.list().control().addListener(SWT.KeyDown, this::key);
    this.eventColumns = new EventColumns(words);
    this.events = new RowTable<>(root, context.theme(), eventColumns.all(), event -> event);
    events.control().setLayoutData(Boxes.fill());
    events.list().named("History of alerts").several();
    events.onOrder(this::showEvents);
    events.list().control().addListener(SWT.KeyDown, this::key);
    lay();
  }

  /** The history, or the alerts again. */
  private void turn() {
    history = !history;
    lay();
    show(page);
    focus();
  }

  private void lay() {
    Boxes.seen(muteAll, !history);
    Boxes.seen(acknowledge, !history);
    Boxes.seen(filter, history);
    Boxes.seen(table.control(), !history);
    Boxes.seen(events.control(), history);
    historyButton.checked(history);
    ((GridData) historyButton.getLayoutData()).grabExcessHorizontalSpace = !history;
    root.layout(true, true);
  }

  @Override
  public Control control() {
    return root;
  }

  private boolean focus() {
    return (history ? events.list() : table.list()).control().setFocus();
  }

  void show(Page next) {
    if (root.isDisposed()) {
      return;
    }
    page = next;
    context.note(next.note());
    muteAll.text(next.mutedUntil().map(until -> "All " + words.muted(until)).orElse("Mute all"))
        .checked(next.mutedUntil().isPresent());
    muteAll.hint(next.mutedUntil().isPresent() ? "Unmutes them" : "Mutes all for " + next.snooze() + " min");
    bar.layout();
    acknowledge.setEnabled(next.waiting() > 0);
    if (next.alerts().isEmpty()) {
      table.list().message(Health.OK, "No alerts",
          "The conditions that raise alerts are in the settings of the sound view.");
    } else {
      table.list().noMessage();
    }
    table.show(table.sorted(next.alerts()));
    if (history) {
      showEvents();
    }
  }

  private void showEvents() {
    List<AlertEvent> fitting = page.history().stream().filter(e -> eventColumns.fits(e, filter.words())).toList();
    if (page.history().isEmpty()) {
      events.list().message(Health.NONE, "Nothing has happened yet",
          "What alerts do is kept here, also for later runs.");
    } else if (fitting.isEmpty()) {
      events.list().message(Health.NONE, "Nothing fits '" + filter.words() + "'", "Esc in the filter clears it.");
    } else {
      events.list().noMessage();
    }
    events.show(events.sorted(fitting));
  }

  private void pressMute() {
    hands.muteAll(page.mutedUntil().isPresent() ? HEARD : Optional.of(page.snooze()));
  }

  private void key(Event e) {
    List<Alert> selected = history ? List.of() : table.list().selected();
    switch (Character.toLowerCase(e.character)) {
      case 'h' -> turn();
      case 'a' -> hands.acknowledge(selected);
      case 'm' -> hands.mute(selected, muted(selected) ? HEARD : Optional.of(page.snooze()));
      default -> {}
    }
  }

  private static boolean muted(List<Alert> alerts) {
    return alerts.stream().allMatch(alert -> alert.mutedUntil().isPresent());
  }

  private List<ViewAction> menu(List<Alert> selected) {
    List<ViewAction> actions = new ArrayList<>();
    if (!selected.isEmpty()) {
      actions.add(action("acknowledge", "Acknowledge\tA", () -> hands.acknowledge(selected)));
      actions.add(action("mute", "Mute for " + page.snooze() + " min\tM",
          () -> hands.mute(selected, Optional.of(page.snooze()))));
      actions.add(action("mute_hour", "Mute for an hour", () -> hands.mute(selected, Optional.of(HOUR))));
      actions.add(action("mute_endless", "Mute until it is unmuted", () -> hands.mute(selected, ENDLESS)));
      if (selected.stream().anyMatch(alert -> alert.mutedUntil().isPresent())) {
        actions.add(action("unmute", "Unmute", () -> hands.mute(selected, HEARD)));
      }
    }
    actions.add(action("history", "Show History\tH", this::turn));
    actions.add(action("mute_all_hour", "Mute all for an hour", () -> hands.muteAll(Optional.of(HOUR))));
    actions.add(action("mute_all", "Mute all until they are unmuted", () -> hands.muteAll(ENDLESS)));
    return actions;
  }

  private static ViewAction action(String id, String label, Runnable run) {
    return new ViewAction(id, label, "", Optional.empty(), run);
  }
}
