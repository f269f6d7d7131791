package org.robotui.uic.graph.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.show.Subject;
import org.robotui.ui.Icon;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.graph.internal.model.Ask;
import org.robotui.uic.graph.internal.model.GraphModel;
import org.robotui.uic.graph.internal.view.GraphSurface;

/** The view: the tick prepares the graph, the surface shows it. */
final class GraphUic implements SwtUic, GraphSurface.Wishes {
  private final UicContext context;
  private final GraphModel model;
  private final List<ViewAction> actions;
  private Optional<GraphSurface> surface = Optional.empty();

  GraphUic(UicContext context) {
    this.context = context;
    this.model = new GraphModel(context);
    model.ask(GraphPreferences.read(context.settings().current()));
    this.actions = List.of(
        new ViewAction("fit", "Show the whole graph", Icon.FIT.id(), Optional.empty(),
            () -> surface.ifPresent(GraphSurface::fit)),
        new ViewAction("anew", "Refresh, and lay out from scratch", Icon.RESTART.id(), Optional.empty(), model::anew),
        new ViewAction("save", "Save the drawing as PNG or SVG", Icon.SAVE.id(), Optional.empty(),
            () -> surface.ifPresent(GraphSurface::save)));
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, GraphOptions.of(context.settings().current()));
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    GraphSurface made = new GraphSurface(parent, ui, this, model::subject,
        new SubjectMenu(context.ruic(), ui.theme(), context.background()));
    surface = Optional.of(made);
    made.show(model.look(), model.ask());
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("0, Home", "Show the whole graph"),
        new ViewKey("+, -", "Zoom"),
        new ViewKey("Arrows", "Move"),
        new ViewKey("Enter", "Expand or collapse a namespace"),
        new ViewKey("Ctrl+F", "Filter"),
        new ViewKey("Esc", "Clear the selection"));
  }

  @Override
  public void refresh() {
    surface.ifPresent(s -> s.show(model.look(), model.ask()));
  }

  @Override
  public void show(String showing, Subject subject) {
    if (subject instanceof Subject.Node node) {
      ask(model.ask().search("").select(model.node(node.name())));
    }
  }

  @Override
  public List<ViewAction> actions() {
    return actions;
  }

  @Override
  public Ask asked() {
    return model.ask();
  }

  @Override
  public void ask(Ask next) {
    model.ask(next);
    GraphPreferences.write(context.settings(), next);
    refresh();
  }

  @Override
  public void widths(TextWidths exact) {
    model.widths(exact);
  }

  @Override
  public void seen() {
    model.seen(System.nanoTime());
  }

  @Override
  public void close() {
    model.close();
  }
}
