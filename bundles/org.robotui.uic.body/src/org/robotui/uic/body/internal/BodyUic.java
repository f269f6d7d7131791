package org.robotui.uic.body.internal;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.uic.body.internal.model.BodyModel;
import org.robotui.uic.body.internal.model.BodyWish;
import org.robotui.uic.body.internal.view.BodySurface;

/** The view: the tick takes and remembers, the surface shows the tree. */
final class BodyUic extends SurfaceUic<BodySurface> {
  private final UicContext context;
  private final BodyModel model;

  BodyUic(UicContext context) {
    this.context = context;
    this.model = new BodyModel(context.input(BodyType.BODY));
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, context.settings().current().number(BodyType.STALE_AFTER));
  }

  @Override
  protected BodySurface open(Composite parent, UiContext ui) {
    return new BodySurface(parent, ui, model::wish, this::wish);
  }

  private void wish(BodyWish next) {
    model.wish(next);
    refresh();
  }

  @Override
  protected void refresh(BodySurface shown) {
    shown.show(model.look(), model.wish());
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(new ViewKey("Enter, arrows", "Expand or collapse a part"), new ViewKey("Ctrl+F, /", "Search"),
        new ViewKey("Esc", "Close the history"));
  }
}
