package org.robotui.uic.graph.internal.view;

import java.util.Optional;
import java.util.function.Function;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.show.Subject;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.diagram.Box;
import org.robotui.ui.diagram.DiagramCanvas;
import org.robotui.ui.diagram.DiagramSaver;
import org.robotui.ui.diagram.DiagramWishes;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.graph.internal.model.Ask;
import org.robotui.uic.graph.internal.model.GraphViewState;
import org.robotui.uic.graph.internal.model.Vertex;

/** What is seen of the view. Display thread. */
public final class GraphSurface implements ViewSurface {
  /** What the user wants. Display thread. */
  public interface Wishes extends DiagramWishes<Ask> {
    /** The view is seen now. */
    void seen();
  }

  private static final int WIDEST_FILTER = 180;

  private final UiContext context;
  private final Wishes wishes;
  private final Composite root;
  private final QuietButton nodes;
  private final QuietButton topics;
  private final QuietButton rates;
  private final QuietButton eye;
  private final FilterField filter;
  private final NoticeLine notice;
  private final DiagramCanvas canvas;
  private final NoticeLine selected;

  /** In a part of a window. */
  public GraphSurface(
      Composite parent, UiContext context, Wishes wishes, Function<Vertex, Optional<Subject>> subject,
      SubjectMenu subjects) {
    this.context = context;
    this.wishes = wishes;
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::focus);
    Composite bar = Boxes.bar(root, theme, 5);
    nodes = new QuietButton(bar, theme, () -> show(false)).text("Nodes")
        .hint("Draw nodes, with topics as wires between them");
    topics = new QuietButton(bar, theme, () -> show(true)).text("Nodes and topics").hint("Draw nodes and topics");
    rates = new QuietButton(bar, theme, () -> wishes.ask(wishes.asked().measure(!wishes.asked().measuring())))
        .text("Rates")
        .hint("Measure what is drawn: all topics, or those of what is selected, up to a number that can be configured");
    eye = new QuietButton(bar, theme, this::choose).icon(Icon.EYE).hint("What is hidden");
    filter = new FilterField(bar, theme, "Filter", words -> wishes.ask(wishes.asked().search(words)));
    filter.setLayoutData(Boxes.end(WIDEST_FILTER));
    notice = new NoticeLine(root, theme, Face.BODY);
    canvas = new DiagramCanvas(root, theme)
        .onSelect(key -> wishes.ask(wishes.asked().select(key.map(Vertex.class::cast)))).onOpen(this::open)
        .hints(GraphSurface::hint).onMenu((menu, box) -> menu(menu, (Vertex) box.key(), subject, subjects));
    canvas.control().setLayoutData(Boxes.fill());
    canvas.fit();
    selected = new NoticeLine(root, theme, Face.BODY);
    filter.onDown(this::focus);
    canvas.onFind(filter::focus);
    wishes.widths(TextWidths.of(root, theme));
  }

  /** Of a topic that no stream carries, no more than its name is known. */
  private static void menu(PopupMenu menu, Vertex vertex, Function<Vertex, Optional<Subject>> subject,
      SubjectMenu subjects) {
    subject.apply(vertex).ifPresentOrElse(s -> subjects.fill(menu, s),
        () -> menu.push("Copy name", () -> Clipboards.copy(vertex.name())));
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what the last tick left, and what was asked for since. */
  public void show(GraphViewState look, Ask ask) {
    if (root.isDisposed()) {
      return;
    }
    if (root.isVisible()) {
      wishes.seen();
    }
    context.note(look.title());
    nodes.checked(!ask.topics());
    topics.checked(ask.topics());
    rates.checked(ask.measuring());
    canvas.state(look.state());
    look.empty().ifPresent(e -> canvas.message(e.health(), e.title(), e.sentence()));
    canvas.show(look.diagram());
    canvas.select(ask.selected());
    look.notice().ifPresent(why -> notice.show(Health.WARNING, why));
    selected.show(Health.NONE, ask.selected().isPresent() ? look.selected() : "");
    boolean moved = Boxes.seen(notice.control(), look.notice().isPresent());
    if (Boxes.seen(selected.control(), ask.selected().isPresent()) || moved) {
      root.layout();
    }
  }

  /** Shows the whole graph. */
  public void fit() {
    canvas.fit();
  }

  /** Saves the drawing, where the user says. */
  public void save() {
    DiagramSaver.ask(canvas, context.theme(), "graph").ifPresent(problem -> {
      notice.show(Health.BAD, problem);
      Boxes.seen(notice.control(), true);
      root.layout();
    });
  }

  private boolean focus() {
    return canvas.control().setFocus();
  }

  private void show(boolean withTopics) {
    Ask ask = wishes.asked();
    wishes.ask(ask.show(withTopics, ask.tools(), ask.tf(), ask.ends(), ask.groups()));
  }

  private void choose() {
    Ask ask = wishes.asked();
    PopupMenu menu = new PopupMenu(eye);
    menu.check("Hide tools (rviz, rqt, /rosout, ...)", ask.tools(),
        on -> wishes.ask(ask.show(ask.topics(), on, ask.tf(), ask.ends(), ask.groups())));
    menu.check("Hide /tf", ask.tf(),
        on -> wishes.ask(ask.show(ask.topics(), ask.tools(), on, ask.ends(), ask.groups())));
    menu.check("Hide dead ends: topics without a publisher or without a subscriber", ask.ends(),
        on -> wishes.ask(ask.show(ask.topics(), ask.tools(), ask.tf(), on, ask.groups())));
    menu.line();
    menu.check("Frame namespaces", ask.groups(),
        on -> wishes.ask(ask.show(ask.topics(), ask.tools(), ask.tf(), ask.ends(), on)));
    menu.openBelow(eye);
  }

  /** A double click on a closed namespace, or on topics in one box, opens it, and on a frame closes it. */
  private void open(Box box) {
    Vertex vertex = (Vertex) box.key();
    if (vertex.kind() == Vertex.Kind.GROUP) {
      wishes.ask(wishes.asked().open(vertex, box.form() != Box.Form.GROUP));
    }
  }

  private static String hint(Box box) {
    Vertex vertex = (Vertex) box.key();
    return switch (vertex.kind()) {
      case GROUP -> (vertex.name().isEmpty() ? vertex.robot() : vertex.name()) + "\ndouble click: "
          + (box.form() == Box.Form.GROUP ? "close to one box" : "open");
      case NODE -> "node " + vertex.name();
      case TOPIC -> "topic " + vertex.name();
    };
  }
}
