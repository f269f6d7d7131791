package org.robotui.uic.log.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.show.Subject;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.DetailSplit;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.SaveDialog;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.LogJson;
import org.robotui.uic.log.internal.model.LogLine;
import org.robotui.uic.log.internal.model.Notice;
import org.robotui.uic.log.internal.model.OriginCount;
import org.robotui.uic.log.internal.model.Search;
import org.robotui.uic.log.internal.model.Wording;

/** What is seen of the view while it is shown. Display thread. */
public final class LogSurface implements ViewSurface {
  private static final int NODES_WIDTH = 220;
  private static final int LIST_SHARE = 70;
  private static final int FIRST_WORDS = 40;

  private final UiContext context;
  private final LogHands hands;
  private final Wording wording;
  private final SubjectMenu subjects;
  private final Composite root;
  private final NoticeLine notice;
  private final LogBar bar;
  private final NodePane nodes;
  private final GridData nodesPlace = new GridData(SWT.FILL, SWT.FILL, false, true);
  private final DetailSplit halves;
  private final ListArea lines;
  private final LogDetailPane detail;
  private Frame frame;

  /** In a part of a window. */
  public LogSurface(Composite parent, UiContext context, Wording wording, LogHands hands, SubjectMenu subjects) {
    this.subjects = subjects;
    this.context = context;
    this.hands = hands;
    this.wording = wording;
    Theme theme = context.theme();
    frame = new Frame(org.robotui.uic.log.internal.model.Shown.NOTHING, LogFilter.ALL,
        new org.robotui.api.port.InputState.Waiting(""), false, false, "");
    root = Boxes.panel(parent, theme, 1);
    bar = new LogBar(root, theme, hands, LogFilter.ALL, this::focusList);
    notice = new NoticeLine(root, theme, Face.BODY);
    Boxes.seen(notice.control(), false);
    Composite middle = Boxes.panel(root, theme, 2);
    middle.setLayoutData(Boxes.fill());
    middle.setBackground(theme.color(Role.LINE));
    ((GridLayout) middle.getLayout()).horizontalSpacing = 1;
    nodes = new NodePane(middle, theme, hands);
    nodesPlace.widthHint = NODES_WIDTH;
    nodes.control().setLayoutData(nodesPlace);
    Boxes.seen(nodes.control(), false);
    halves = new DetailSplit(middle, theme, LIST_SHARE).thin();
    lines = new ListArea(halves.parts(), theme, wording, () -> hands.pause(false));
    detail = new LogDetailPane(halves.parts(), theme, wording, this::copy, this::closeDetail);
    halves.detail(false);
    lines.list().onSelect(this::selected).onFind(bar::find).menu(this::fill);
    lines.list().control().addListener(SWT.KeyDown, this::key);
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what the last tick left. */
  public void show(Frame next) {
    if (root.isDisposed()) {
      return;
    }
    frame = next;
    context.note(next.told().isEmpty() ? Notice.title(next.shown()) : next.told());
    bar.show(next);
    Optional<Notice> above = Notice.above(next.shown(), next.state());
    above.ifPresent(n -> notice.show(n.health(), n.title() + ": " + n.sentence()));
    boolean moved = Boxes.seen(notice.control(), above.isPresent()) | Boxes.seen(nodes.control(), next.nodes());
    if (next.nodes()) {
      nodes.show(next.shown().origins(), next.filter());
    }
    if (moved) {
      root.layout(true, true);
    }
    lines.show(next);
    List<LogLine> selected = lines.selected();
    if (selected.size() == 1 && halves.isDetailed()) {
      detail.show(selected.getFirst());
    }
  }

  /** Asks for a file, and has what is shown written to it. */
  public void save() {
    if (root.isDisposed()) {
      return;
    }
    SaveDialog.ask(root, "Save the log", "robot.log").ifPresent(file -> hands.save(frame.shown().lines(), file));
  }

  private void selected(List<LogLine> chosen) {
    if (chosen.size() == 1) {
      detail.show(chosen.getFirst());
      if (halves.detail(true)) {
        lines.list().select(chosen.getFirst().id());
      }
    }
  }

  private void closeDetail() {
    detail.nothing();
    halves.detail(false);
    lines.list().selectNone();
    focusList();
  }

  private void focusList() {
    lines.list().control().setFocus();
  }

  private void key(Event event) {
    if (event.keyCode == SWT.ESC) {
      closeDetail();
    } else if (event.character == 'p') {
      hands.pause(!frame.paused());
    }
  }

  private void copy() {
    List<LogLine> chosen = lines.selected().isEmpty() ? frame.shown().lines() : lines.selected();
    Clipboards.copy(chosen.stream().map(wording::text).collect(Collectors.joining("\n")));
  }

  private void fill(PopupMenu menu, List<LogLine> chosen) {
    menu(chosen).forEach(menu::action);
    chosen.stream().findFirst().ifPresent(
        line -> subjects.fill(menu.line().under(line.last().origin()), new Subject.Node(line.last().origin())));
  }

  private List<ViewAction> menu(List<LogLine> chosen) {
    List<ViewAction> actions = new ArrayList<>();
    if (!chosen.isEmpty()) {
      LogLine line = chosen.getFirst();
      actions.add(NodePane.action("copy", chosen.size() == 1 ? "Copy this entry" : "Copy " + chosen.size() + " entries",
          this::copy));
      actions.add(NodePane.action("json", "Copy as JSON",
          () -> Clipboards.copy(chosen.stream().map(LogJson::of).collect(Collectors.joining()))));
      actions.addAll(NodePane.menu(List.of(new OriginCount(line.last().origin(), 0)), frame.filter(), hands));
      actions.add(NodePane.action("alike", "Search for this message",
          () -> hands.filter(frame.filter().search(Search.of(line.last().firstLine(FIRST_WORDS), false)))));
    }
    actions.add(NodePane.action("show_all", "Show all levels and nodes, and end the search", hands::showAll));
    actions.add(NodePane.action("clear", "Clear", hands::clear));
    return actions;
  }
}
