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
import org.robotui.api.show.Subject;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.show.DraggedPorts;
import org.robotui.ui.show.PortDrag;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.topics.internal.model.Key;
import org.robotui.uic.topics.internal.model.TopicRow;
import org.robotui.uic.topics.internal.model.TopicsViewState;

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
  private final SubjectMenu subjects;
  private final Composite root;
  private final StackLayout stack = new StackLayout();
  private final RowTable<TopicRow> topics;
  private final RowTable<TopicRow> nodes;
  private final RowTable<TopicRow> others;
  private volatile Kind section = Kind.TOPIC;

  Shelf(Composite parent, Theme theme, Acts acts, String ruic, SubjectMenu subjects) {
    this.acts = acts;
    this.subjects = subjects;
    root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    root.setLayout(stack);
    topics = new RowTable<>(root, theme, TopicColumns.topics(theme), TopicRow::key).onOrder(acts::reorder);
    nodes = new RowTable<>(root, theme, TopicColumns.nodes(), TopicRow::key).onOrder(acts::reorder);
    others = new RowTable<>(root, theme, TopicColumns.others(), TopicRow::key).onOrder(acts::reorder);
    listen(topics, "Topics");
    listen(nodes, "Nodes");
    listen(others, "Services and actions");
    PortDrag.from(topics.list().control(), at -> Optional.of(new DraggedPorts(ruic,
        topics.list().selected().stream().flatMap(row -> row.entry().stream().stream()).map(Subject.Stream::of)
            .toList())));
    topics.list().control().addListener(SWT.MouseUp, this::clicked);
    topics.list().control().addListener(SWT.KeyDown, this::key);
    stack.topControl = topics.control();
  }

  Control control() {
    return root;
  }

  RowTable<TopicRow> table() {
    return switch (section) {
      case TOPIC -> topics;
      case NODE -> nodes;
      default -> others;
    };
  }

  /** Sorts as the user chose. Any thread. */
  List<TopicRow> sorted(List<TopicRow> rows) {
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

  void show(TopicsViewState look) {
    if (look.wishes().section() != section) {
      return;
    }
    RowTable<TopicRow> table = table();
    table.show(look.rows());
    if (!StateView.showsContent(look.state())) {
      // Nothing is waited for here but an answer.
      message(table, look.state());
    } else if (!look.rows().isEmpty()) {
      table.list().noMessage();
    } else if (look.total() > 0) {
      table.list().message(Health.NONE, "No match",
          "None of " + look.total() + " contains these words. Esc clears the filter.");
    } else {
      table.list().message(Health.NONE, "No " + TopicText.section(section).toLowerCase(Locale.ROOT),
          "The robot has none now.");
    }
  }

  private static void message(RowTable<TopicRow> table, InputState state) {
    String title = switch (state) {
      case InputState.Failed f -> "No answer";
      case InputState.Waiting w -> "Asking";
      default -> "No robot to look into";
    };
    table.list().message(StateView.health(state), title, state.explanation());
  }

  private void listen(RowTable<TopicRow> table, String name) {
    table.list().named(name).onFind(acts::find)
        .onSelect(rows -> acts.select(rows.stream().findFirst().map(TopicRow::key)))
        .onOpen(row -> acts.open(row.key()))
        .menu((menu, rows) -> rows.stream().findFirst().ifPresent(row -> menu(menu, row)));
  }

  private void menu(PopupMenu menu, TopicRow row) {
    Key key = row.key();
    Optional<Subject> subject = switch (key.kind()) {
      case TOPIC -> row.entry().stream().map(Subject.Stream::of);
      case NODE -> Optional.of(new Subject.Node(key.name()));
      default -> Optional.empty();
    };
    if (key.kind() == Kind.TOPIC) {
      menu.push("Show messages", () -> acts.open(key));
      menu.check("Measure", row.measured(), on -> measure(row));
    }
    subject.ifPresentOrElse(s -> subjects.fill(menu, s),
        () -> menu.push("Copy name", () -> Clipboards.copy(key.name())));
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

  private void measure(TopicRow row) {
    if (row.entry().stream().isPresent() || row.measured()) {
      acts.measure(row.key(), !row.measured());
    }
  }
}
