package org.robotui.uic.graph.internal;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.show.Subject;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.ui.diagram.DiagramCanvas;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.graph.internal.model.Ask;
import org.robotui.uic.graph.internal.model.GraphModel;
import org.robotui.uic.graph.internal.view.GraphSurface;

/** The view: the tick prepares the graph, the surface shows it. */
final class GraphUic extends SurfaceUic<GraphSurface> implements GraphSurface.Wishes {
  private final UicContext context;
  private final GraphModel model;

  GraphUic(UicContext context) {
    this.context = context;
    this.model = new GraphModel(context);
    model.ask(GraphPreferences.read(context.settings().current()));
    offers().action("fit", "Show the whole graph", Icon.FIT, GraphSurface::fit)
        .add("anew", "Refresh, and lay out from scratch", Icon.RESTART, model::anew)
        .action("save", "Save the drawing as PNG or SVG", Icon.SAVE, GraphSurface::save);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, GraphOptions.of(context.settings().current()));
  }

  @Override
  protected GraphSurface open(Composite parent, UiContext ui) {
    return new GraphSurface(parent, ui, this, model::subject, new SubjectMenu(context, ui.theme()));
  }

  @Override
  protected void refresh(GraphSurface shown) {
    shown.show(model.look(), model.ask());
  }

  @Override
  public List<ViewKey> keys() {
    return DiagramCanvas.keys("graph", "Expand or collapse a namespace");
  }

  @Override
  public void show(String showing, Subject subject) {
    if (subject instanceof Subject.Node node) {
      ask(model.ask().search("").select(model.node(node.name())));
    }
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
