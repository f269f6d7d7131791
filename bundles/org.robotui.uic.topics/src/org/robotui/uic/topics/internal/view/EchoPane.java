package org.robotui.uic.topics.internal.view;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.InputState;
import org.robotui.api.show.Subject;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RecordTree;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.show.DraggedPorts;
import org.robotui.ui.show.PortDrag;
import org.robotui.ui.show.RecordYaml;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.topics.internal.model.Heard;
import org.robotui.uic.topics.internal.model.TopicsModel;
import org.robotui.uic.topics.internal.model.TopicsViewState;

/** The messages of a topic: the newest as a tree, and those before it. Display thread. */
final class EchoPane {
  private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss.SSS");
  private static final int HISTORY_WIDTH = 196;
  private static final int WIDE_FROM = 560;
  private static final long NANOS_PER_MILLI = 1_000_000;

  private final TopicsModel model;
  private final Composite root;
  private final NoticeLine figures;
  private final QuietButton pause;
  private final RecordTree tree;
  private final Composite rule;
  private final RowTable<Heard> history;
  private TopicsViewState.Echo shown = TopicsViewState.Echo.NOTHING;
  private Optional<Boolean> wanted = Optional.empty();

  EchoPane(Composite parent, Theme theme, TopicsModel model, String ruic, SubjectMenu subjects) {
    this.model = model;
    root = Boxes.panel(parent, theme, 1);
    Composite bar = Boxes.bar(root, theme, 4);
    figures = new NoticeLine(bar, theme, Face.SMALL_FIGURES);
    pause = new QuietButton(bar, theme, this::pause).icon(Icon.PAUSE).hint("Pause (H)");
    new QuietButton(bar, theme, this::history).icon(Icon.TEXT).hint("Messages before this one");
    new QuietButton(bar, theme, this::copy).icon(Icon.COPY).hint("Copy the message as text");
    Composite body = Boxes.panel(root, theme, 3);
    body.setLayoutData(Boxes.fill());
    tree = new RecordTree(body, theme);
    tree.control().setLayoutData(Boxes.fill());
    tree.menu((menu, path) -> field(path).ifPresent(field -> subjects.fill(menu, field)));
    PortDrag.from(tree.control(),
        at -> tree.selected().flatMap(this::field).map(field -> new DraggedPorts(ruic, List.of(field))));
    rule = new Composite(body, SWT.NONE);
    rule.setBackground(theme.color(Role.LINE));
    GridData line = new GridData(SWT.FILL, SWT.FILL, false, true);
    line.widthHint = 1;
    rule.setLayoutData(line);
    history = new RowTable<>(body, theme, columns(), Heard::number);
    GridData side = new GridData(SWT.FILL, SWT.FILL, false, true);
    side.widthHint = HISTORY_WIDTH;
    history.control().setLayoutData(side);
    history.list().named("Messages")
        .onSelect(rows -> rows.stream().findFirst().ifPresent(heard -> model.pin(heard.number())));
    body.addListener(SWT.Resize, e -> arrange(body));
    tree.control().addListener(SWT.KeyDown, e -> {
      if (e.character == 'h') {
        pause();
      }
    });
  }

  Control control() {
    return root;
  }

  void show(TopicsViewState look) {
    shown = look.echo();
    boolean held = look.wishes().paused();
    pause.checked(held).icon(held ? Icon.PLAY : Icon.PAUSE).hint(held ? "Resume (H)" : "Pause (H)");
    figures.show(shown.source().isEmpty() ? Health.NONE : StateView.health(shown.state()), figures(held));
    history.show(shown.history());
    if (!held) {
      history.list().selectNone();
    } else {
      shown.shown().ifPresent(heard -> mark(heard.number()));
    }
    tree(look);
  }

  private void mark(long number) {
    if (history.list().selected().stream().noneMatch(heard -> heard.number() == number)) {
      history.list().select(number);
    }
  }

  private void tree(TopicsViewState look) {
    if (shown.source().isEmpty()) {
      tree.clear();
      tree.message(Health.NONE, shown.obstacle().isEmpty() ? "No topic is open" : "No messages to show",
          shown.obstacle());
    } else if (shown.record().isEmpty()) {
      tree.clear();
      tree.noMessage();
      tree.state(shown.state());
      if (StateView.showsContent(shown.state())) {
        tree.message(Health.WAITING, "Waiting for the next message", "");
      }
    } else {
      tree.noMessage();
      // A held message is what it is; only one that claims to be the newest can be too old.
      tree.state(look.wishes().paused() ? new InputState.Live(0, 0) : shown.state());
      tree.show(shown.record().get());
    }
  }

  private String figures(boolean held) {
    String measure = TopicText.measure(shown.measure());
    return held && shown.missed() > 0 ? "paused, " + shown.missed() + " more came  \u00b7  " + measure
        : held ? "paused  \u00b7  " + measure : measure;
  }

  private void pause() {
    model.pause(!model.look().wishes().paused());
  }

  private void history() {
    wanted = Optional.of(!history.control().getVisible());
    arrange(rule.getParent());
  }

  private void copy() {
    shown.record().ifPresent(record -> Clipboards.copy(RecordYaml.of(record)));
  }

  private void arrange(Composite body) {
    int width = body.getClientArea().width;
    boolean seen = wanted.orElse(width >= WIDE_FROM);
    ((GridData) history.control().getLayoutData()).widthHint = Math.min(HISTORY_WIDTH, width / 2);
    if (Boxes.seen(rule, seen) | Boxes.seen(history.control(), seen)) {
      body.layout();
    }
  }

  private Optional<Subject.Stream> field(String path) {
    return shown.source().map(source -> new Subject.Stream(source, List.of(path)));
  }

  private static List<Column<Heard>> columns() {
    return List.of(
        Column.<Heard>values("Received", EchoPane::received).hint(heard -> "Message " + heard.number()),
        Column
            .<Heard>figures("Size",
                heard -> heard.size().isPresent() ? TopicText.bytes(heard.size().getAsInt(), "B") : "")
            .width(80).role(Role.DIM));
  }

  private static String received(Heard heard) {
    long ago = (System.nanoTime() - heard.envelope().receivedNanos()) / NANOS_PER_MILLI;
    return Instant.ofEpochMilli(System.currentTimeMillis() - ago).atZone(ZoneId.systemDefault()).format(CLOCK);
  }
}
