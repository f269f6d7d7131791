package org.robotui.uic.team.internal.view;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.team.internal.model.TeamCommands;
import org.robotui.uic.team.internal.model.TeamLook;
import org.robotui.uic.team.internal.model.TeamRow;

/** What is seen of the view: buttons, a filter, and the table of robots. Display thread, but for {@link #prepare}. */
public final class TeamSurface implements ViewSurface {
  private static final int BUTTONS = 5;
  private static final int LEAST_FILTER = 90;

  /** What is to be painted. */
  private record Shown(TeamLook look, List<TeamRow> rows) {}

  private final UiContext context;
  private final TeamCommands commands;
  private final Composite root;
  private final CommandBar bar;
  private final FilterField filter;
  private final RowTable<TeamRow> table;
  private volatile String words = "";
  private volatile Optional<Shown> shown = Optional.empty();
  private Set<String> selected = Set.of();

  /** Makes the controls. */
  public TeamSurface(Composite parent, UiContext context, TeamCommands commands) {
    this.context = context;
    this.commands = commands;
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::focus);
    Composite buttons = Boxes.bar(root, theme, BUTTONS);
    bar = new CommandBar(root, theme, commands, buttons);
    filter = new FilterField(buttons, theme, "Filter robots", this::search);
    GridData right = new GridData(SWT.FILL, SWT.CENTER, true, false);
    right.widthHint = LEAST_FILTER;
    filter.setLayoutData(right);
    buttons.addListener(SWT.Resize, e -> fit(buttons));
    table = new RowTable<>(root, theme, new TeamColumns(theme).all(), TeamRow::robot);
    table.control().setLayoutData(Boxes.fill());
    bar.below(table.control());
    table.onOrder(this::again);
    table.list().named("Robots").several().onSelect(this::chosen).onOpen(r -> bar.tell(commands.open(r.robot())))
        .onFind(filter::focus).menu(this::menu);
    table.list().control().addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        bar.no();
        select(Set.of());
      }
    });
    filter.onDown(this::focus);
  }

  /** Buttons are never cut: where it is narrow, the filter goes. */
  private void fit(Composite buttons) {
    int needed = Arrays.stream(buttons.getChildren()).filter(c -> c != filter)
        .mapToInt(c -> c.computeSize(SWT.DEFAULT, SWT.DEFAULT).x + Theme.STEP).sum();
    boolean room = buttons.getClientArea().width - needed >= LEAST_FILTER;
    if (!room && !filter.words().isEmpty()) {
      filter.words("");
    }
    if (Boxes.seen(filter, room)) {
      buttons.layout();
    }
  }

  private boolean focus() {
    return table.list().control().setFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Filters and sorts what is to be shown next. Any thread. */
  public void prepare(TeamLook look) {
    shown = Optional.of(new Shown(look, table.sorted(look.matching(words))));
  }

  /** Shows what was prepared. */
  public void refresh() {
    if (!root.isDisposed()) {
      shown.ifPresent(this::show);
    }
  }

  RowTable<TeamRow> table() {
    return table;
  }

  CommandBar bar() {
    return bar;
  }

  FilterField filterField() {
    return filter;
  }

  private void search(String typed) {
    words = typed;
    again();
    table.highlight(typed);
  }

  private void again() {
    shown.ifPresent(s -> prepare(s.look()));
    refresh();
  }

  private void show(Shown next) {
    TeamLook look = next.look();
    context.note(look.rows().isEmpty() ? "" : look.note());
    table.show(next.rows());
    table.list().state(look.state());
    if (!look.selected().equals(selected)) {
      selected = look.selected();
      table.list().selectAll(selected);
    }
    List<String> robots = look.rows().stream().map(TeamRow::robot).toList();
    bar.show(robots, robots.stream().filter(selected::contains).toList());
    if (next.rows().isEmpty() && StateView.showsContent(look.state())) {
      table.list().message(Health.NONE, "No match", "No robot contains these words. Esc clears the filter.");
    } else {
      table.list().noMessage();
    }
  }

  /** Selected by hand: for all views. */
  private void chosen(List<TeamRow> rows) {
    Set<String> robots = new LinkedHashSet<>();
    rows.forEach(r -> robots.add(r.robot()));
    select(robots);
  }

  void select(Set<String> robots) {
    selected = Set.copyOf(robots);
    commands.select(robots);
    table.list().selectAll(selected);
    shown.ifPresent(
        s -> shown = Optional.of(new Shown(new TeamLook(s.look().rows(), selected, s.look().state()), s.rows())));
    refresh();
  }

  private List<ViewAction> menu(List<TeamRow> rows) {
    List<String> robots = rows.stream().map(TeamRow::robot).toList();
    if (robots.isEmpty()) {
      return List.of();
    }
    String whom = robots.size() == 1 ? robots.getFirst() : robots.size() + " robots";
    return List.of(
        action("open", "Open the UI of " + robots.getFirst(), Icon.OPEN,
            () -> bar.tell(commands.open(robots.getFirst()))),
        action("stop", "Stop " + whom, Icon.STOP, bar::stop),
        action("release", "Release the stop of " + whom, Icon.PLAY, bar::release),
        action("zero", "Send velocity zero to " + whom, Icon.PAUSE, bar::zero));
  }

  private static ViewAction action(String id, String label, Icon icon, Runnable run) {
    return new ViewAction(id, label, icon.id(), Optional.empty(), run);
  }
}
