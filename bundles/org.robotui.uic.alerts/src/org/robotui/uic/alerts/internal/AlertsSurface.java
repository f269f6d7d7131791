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
import org.robotui.api.alert.AlertWords;
import org.robotui.ui.Health;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
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
  private Page page = new Page(List.of(), Optional.empty(), 0);

  AlertsSurface(Composite parent, UiContext context, AlertActions hands, AlertWords words) {
    this.context = context;
    this.hands = hands;
    this.words = words;
    this.root = Boxes.root(parent, context.theme(), this::focus);
    this.bar = Boxes.bar(root, context.theme(), 2);
    this.muteAll = new QuietButton(bar, context.theme(), this::pressMute).text("Mute all");
    muteAll.setLayoutData(Boxes.middle());
    this.acknowledge =
        new QuietButton(bar, context.theme(), () -> hands.acknowledge(page.alerts())).text("Acknowledge all")
            .hint("Acknowledges all: they are silent, and are removed when they are over");
    acknowledge.setLayoutData(new GridData(SWT.END, SWT.CENTER, true, false));
    this.table = new RowTable<>(root, context.theme(), new AlertColumns(words).all(), Alert::id);
    table.control().setLayoutData(Boxes.fill());
    table.list().named("Alerts").several().onOpen(alert -> hands.acknowledge(List.of(alert))).menu(this::menu);
    table.onOrder(() -> table.show(table.sorted(page.alerts())));
    table.list().control().addListener(SWT.KeyDown, this::key);
  }

  @Override
  public Control control() {
    return root;
  }

  private boolean focus() {
    return table.list().control().setFocus();
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
  }

  private void pressMute() {
    hands.muteAll(page.mutedUntil().isPresent() ? HEARD : Optional.of(page.snooze()));
  }

  private void key(Event e) {
    List<Alert> selected = table.list().selected();
    switch (Character.toLowerCase(e.character)) {
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
    actions.add(action("mute_all_hour", "Mute all for an hour", () -> hands.muteAll(Optional.of(HOUR))));
    actions.add(action("mute_all", "Mute all until they are unmuted", () -> hands.muteAll(ENDLESS)));
    return actions;
  }

  private static ViewAction action(String id, String label, Runnable run) {
    return new ViewAction(id, label, "", Optional.empty(), run);
  }
}
