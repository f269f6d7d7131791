package org.robotui.uic.topics.internal.view;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.topics.internal.model.Key;
import org.robotui.uic.topics.internal.model.Look;
import org.robotui.uic.topics.internal.model.Row;

/** The lists: one with figures for topics, one for nodes, one for all else. Display thread, but for {@link #sorted}. */
final class Shelf {
  /** What happens to rows. */
  interface Acts {
    void select(Optional<Key> key);

    void open(Key key);

    void measure(Key key, boolean on);

    void reorder();

    void find();
  }

  private final Acts acts;
  private final Composite root;
  private final StackLayout stack = new StackLayout();
  private final RowTable<Row> topics;
  private final RowTable<Row> nodes;
  private final RowTable<Row> others;
  private volatile Kind section = Kind.TOPIC;

  Shelf(Composite parent, Theme theme, Acts acts) {
    this.acts = acts;
    root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    root.setLayout(stack);
    topics = new RowTable<>(root, theme, TopicColumns.topics(theme), Row::key).onOrder(acts::reorder);
    nodes = new RowTable<>(root, theme, TopicColumns.nodes(), Row::key).onOrder(acts::reorder);
    others = new RowTable<>(root, theme, TopicColumns.others(), Row::key).onOrder(acts::reorder);
    listen(topics, "Topics");
    listen(nodes, "Nodes");
    listen(others, "Services and actions");
    topics.list().drag(row -> row.entry().stream().map(Object::toString));
    topics.list().control().addListener(SWT.MouseUp, this::clicked);
    topics.list().control().addListener(SWT.KeyDown, this::key);
    stack.topControl = topics.control();
  }

  Control control() {
    return root;
  }

  RowTable<Row> table() {
    return switch (section) {
      case TOPIC -> topics;
      case NODE -> nodes;
      default -> others;
    };
  }

  /** Sorts as the user chose. Any thread. */
  List<Row> sorted(List<Row> rows) {
    return table().sorted(rows);
  }

  void section(Kind kind) {
    section = kind;
    if (stack.topControl != table().control()) {
      stack.topControl = table().control();
      root.layout();
    }
  }

  Kind section() {
    return section;
  }

  void highlight(String words) {
    topics.highlight(words);
    nodes.highlight(words);
    others.highlight(words);
  }

  void show(Look look) {
    if (look.wishes().section() != section) {
      return;
    }
    RowTable<Row> table = table();
    table.show(look.rows());
    if (!StateView.showsContent(look.state())) {
      // Nothing is waited for here but an answer.
      message(table, look.state());
    } else if (!look.rows().isEmpty()) {
      table.list().noMessage();
    } else if (look.total() > 0) {
      table.list().message(Health.NONE, "Nothing fits", "None of " + look.total() + " contains these words. Esc clears the filter.");
    } else {
      table.list().message(Health.NONE, "No " + Words.section(section).toLowerCase(Locale.ROOT), "The robot has none now.");
    }
  }

  private static void message(RowTable<Row> table, InputState state) {
    String title = switch (state) {
      case InputState.Failed f -> "No answer";
      case InputState.Waiting w -> "Asking";
      default -> "No robot to look into";
    };
    table.list().message(StateView.health(state), title, state.explanation());
  }

  private void listen(RowTable<Row> table, String name) {
    table.list().named(name).onFind(acts::find)
        .onSelect(rows -> acts.select(rows.stream().findFirst().map(Row::key)))
        .onOpen(row -> acts.open(row.key()))
        .menu(rows -> rows.stream().findFirst().map(this::menu).orElse(List.of()));
  }

  private List<ViewAction> menu(Row row) {
    ViewAction copy = action("copy", "Copy name", () -> Clipboards.copy(row.key().name()));
    if (row.key().kind() != Kind.TOPIC) {
      return List.of(copy);
    }
    return List.of(action("echo", "Echo", () -> acts.open(row.key())),
        new ViewAction("measure", "Measure", "", Optional.of(row::measured), () -> measure(row)), copy);
  }

  private static ViewAction action(String id, String label, Runnable run) {
    return new ViewAction(id, label, Icon.COPY.id(), Optional.empty(), run);
  }

  private void clicked(Event event) {
    if (event.button == 1 && event.x < TopicColumns.TICK_WIDTH) {
      topics.list().selected().stream().findFirst().ifPresent(this::measure);
    }
  }

  private void key(Event event) {
    if (event.character == 'm') {
      topics.list().selected().forEach(this::measure);
    }
  }

  private void measure(Row row) {
    if (row.entry().stream().isPresent() || row.measured()) {
      acts.measure(row.key(), !row.measured());
    }
  }
}
