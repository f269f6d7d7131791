package org.robotui.uic.tftree.internal.view;

import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.show.Subject;
import org.robotui.data.FrameId;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.DetailSplit;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.diagram.DiagramCanvas;
import org.robotui.ui.diagram.DiagramSaver;
import org.robotui.ui.diagram.DiagramWishes;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.tftree.internal.model.Ask;
import org.robotui.uic.tftree.internal.model.FrameRow;
import org.robotui.uic.tftree.internal.model.Notice;
import org.robotui.uic.tftree.internal.model.TfTreeViewState;

/** What is seen of the view. Display thread. */
public final class TfTreeSurface implements ViewSurface {
  private static final int WIDEST_FILTER = 180;
  private static final int BESIDE_FROM = 760;
  private static final int TREE_SHARE = 66;

  private final UiContext context;
  private final DiagramWishes<Ask> wishes;
  private final Composite root;
  private final QuietButton drawn;
  private final QuietButton listed;
  private final QuietButton problems;
  private final FilterField filter;
  private final NoticeLine notice;
  private final DetailSplit halves;
  private final Composite stack;
  private final StackLayout top = new StackLayout();
  private final DiagramCanvas canvas;
  private final FrameTable table;
  private final FrameDetailPane detail;
  private Optional<TfTreeViewState> shown = Optional.empty();

  /** In a part of a window. */
  public TfTreeSurface(Composite parent, UiContext context, DiagramWishes<Ask> wishes, SubjectMenu subjects) {
    this.context = context;
    this.wishes = wishes;
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::focus);
    Composite bar = Boxes.bar(root, theme, 4);
    drawn = new QuietButton(bar, theme, () -> wishes.ask(wishes.asked().drawn(true))).text("Tree")
        .hint("Draw the frames as a tree");
    listed =
        new QuietButton(bar, theme, () -> wishes.ask(wishes.asked().drawn(false))).text("List").hint("List the frames");
    problems = new QuietButton(bar, theme, () -> wishes.ask(wishes.asked().problems(!wishes.asked().problems())))
        .text("Problems")
        .hint("Show only frames with a problem, and those above them");
    filter = new FilterField(bar, theme, "Filter", this::search);
    filter.setLayoutData(Boxes.end(WIDEST_FILTER));
    notice = new NoticeLine(root, theme, Face.BODY);
    halves = new DetailSplit(root, theme, TREE_SHARE).besideFrom(BESIDE_FROM, TREE_SHARE).thin();
    stack = Boxes.panel(halves.parts(), theme, 1);
    stack.setLayout(top);
    canvas = new DiagramCanvas(stack, theme).onSelect(key -> select(key.map(FrameId.class::cast)))
        .onOpen(box -> wishes.ask(wishes.asked().toggle((FrameId) box.key()))).hints(box -> hint((FrameId) box.key()));
    table = new FrameTable(stack, theme, this::select, frame -> wishes.ask(wishes.asked().toggle(frame)));
    detail = new FrameDetailPane(halves.parts(), theme, wishes, () -> select(Optional.empty()));
    halves.detail(false);
    listen(theme);
    canvas.onMenu((menu, box) -> subjects.fill(menu, new Subject.Frame((FrameId) box.key())));
    table.list().menu(
        (menu, rows) -> rows.stream().findFirst().ifPresent(row -> subjects.fill(menu, new Subject.Frame(row.id()))));
  }

  private void listen(Theme theme) {
    table.list().onFind(filter::focus);
    filter.onDown(this::focus);
    canvas.onFind(filter::focus);
    wishes.widths(TextWidths.of(root, theme));
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what the last tick left, and what was asked for since. */
  public void show(TfTreeViewState look, Ask ask) {
    if (root.isDisposed()) {
      return;
    }
    shown = Optional.of(look);
    context.note(look.title());
    drawn.checked(ask.drawn());
    listed.checked(!ask.drawn());
    problems.checked(ask.problems());
    notice(look);
    canvas.state(look.state());
    look.nothing().ifPresent(n -> canvas.message(n.health(), n.title(), n.sentence()));
    canvas.show(look.drawing());
    canvas.select(ask.selected());
    table.show(look, ask);
    detail.show(look.detail());
    arrange(ask);
  }

  /** Shows the whole tree. */
  public void fit() {
    canvas.fit();
  }

  /** Saves the drawing, where the user says. */
  public void save() {
    DiagramSaver.ask(canvas, context.theme(), "frames").ifPresent(problem -> notice.show(Health.BAD, problem));
  }

  private void notice(TfTreeViewState look) {
    boolean any = !look.notices().isEmpty();
    if (any) {
      Notice first = look.notices().getFirst();
      notice.show(first.health(), look.notices().stream().map(Notice::words).collect(Collectors.joining(".  ")));
    }
    if (Boxes.seen(notice.control(), any)) {
      root.layout();
    }
  }

  private void arrange(Ask ask) {
    Control wanted = ask.drawn() ? canvas.control() : table.control();
    if (top.topControl != wanted) {
      top.topControl = wanted;
      stack.layout();
    }
    halves.detail(ask.selected().isPresent() && shown.filter(look -> look.detail().isPresent()).isPresent());
  }

  private boolean focus() {
    return top.topControl == canvas.control() ? canvas.control().setFocus() : table.list().control().setFocus();
  }

  private void search(String words) {
    Ask next = wishes.asked().search(words);
    if (!next.equals(wishes.asked())) {
      wishes.ask(next);
    }
  }

  private void select(Optional<FrameId> frame) {
    if (!wishes.asked().selected().equals(frame)) {
      wishes.ask(wishes.asked().select(frame));
    }
  }

  private String hint(FrameId frame) {
    return shown.flatMap(look -> look.rows().stream().filter(row -> row.id().equals(frame)).findFirst())
        .map(TfTreeSurface::hint).orElse("");
  }

  private static String hint(FrameRow row) {
    String sender = row.link().map(link -> "\nsent by " + link.authority()).orElse("");
    String fold =
        row.below() == 0 ? "" : "\ndouble click: " + (row.open() ? "hide" : "show") + " the " + row.below() + " below";
    return row.id() + "\n" + row.note() + sender + fold;
  }

  FilterField filterField() {
    return filter;
  }

  FrameTable table() {
    return table;
  }

  DiagramCanvas canvas() {
    return canvas;
  }

  String noticed() {
    return notice.words();
  }
}
