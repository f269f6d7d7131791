package org.robotui.uic.tftree.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.show.Subject;
import org.robotui.data.FrameId;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewItem;
import org.robotui.ui.ViewKey;
import org.robotui.ui.diagram.DiagramCanvas;
import org.robotui.ui.diagram.DiagramWishes;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.tftree.internal.model.Ask;
import org.robotui.uic.tftree.internal.model.TfTreeModel;
import org.robotui.uic.tftree.internal.view.TfTreeSurface;

/** The view: the tick takes the frames and draws the tree, the surface shows it. */
final class TfTreeUic extends SurfaceUic<TfTreeSurface> implements DiagramWishes<Ask> {
  private final UicContext context;
  private final TfTreeModel model;

  TfTreeUic(UicContext context) {
    this.context = context;
    this.model = new TfTreeModel(context);
    model.ask(FramePreferences.read(context.settings().current()));
    offers().action("fit", "Show the whole tree", Icon.FIT, TfTreeSurface::fit)
        .add("open", "Expand all", Icon.OPEN, () -> ask(model.ask().opened()))
        .add("reset", "Reset: forget transforms that are not fixed", Icon.RESTART, context.ruic()::reset)
        .action("save", "Save the drawing as PNG or SVG", Icon.SAVE, TfTreeSurface::save);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, context.settings().current().number(TfTreeType.STALE_AFTER));
  }

  @Override
  protected TfTreeSurface open(Composite parent, UiContext ui) {
    return new TfTreeSurface(parent, ui, this, new SubjectMenu(context, ui.theme()));
  }

  @Override
  protected void refresh(TfTreeSurface shown) {
    shown.show(model.look(), model.ask());
  }

  @Override
  public List<ViewKey> keys() {
    return DiagramCanvas.keys("tree", "Expand or collapse a frame");
  }

  @Override
  public List<ViewItem> items() {
    return model.frames().stream().map(id -> new ViewItem("Frame", id.name(), id.robot(), () -> select(id))).toList();
  }

  @Override
  public void show(String showing, Subject subject) {
    if (subject instanceof Subject.Frame frame) {
      select(frame.frame());
    }
  }

  private void select(FrameId frame) {
    ask(model.ask().search("").problems(false).opened().select(Optional.of(frame)));
  }

  @Override
  public Ask asked() {
    return model.ask();
  }

  @Override
  public void ask(Ask next) {
    model.ask(next);
    FramePreferences.write(context.settings(), next);
    refresh();
  }

  @Override
  public void widths(TextWidths exact) {
    model.widths(exact);
  }
}
