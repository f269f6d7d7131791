package org.robotui.uic.parameters.internal;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewItem;
import org.robotui.ui.ViewKey;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.view.ParametersSurface;

/** The view: the model is prepared by ticks, the surface shows it. */
final class ParametersUic extends SurfaceUic<ParametersSurface> {
  private final UicContext context;
  private final ParametersModel model;

  ParametersUic(UicContext context) {
    this.context = context;
    this.model = new ParametersModel(context);
    offers().add("undo", "Undo the last change (Ctrl+Z)", Icon.UNDO, model::undo)
        .add("refresh", "Read all again (F5)", Icon.RESTART, model::refresh);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, ParametersOptions.of(context.settings().current()));
  }

  @Override
  protected ParametersSurface open(Composite parent, UiContext ui) {
    return new ParametersSurface(parent, ui, model);
  }

  @Override
  protected void refresh(ParametersSurface shown) {
    shown.refresh();
  }

  @Override
  public List<ViewItem> items() {
    return model.parameters().stream()
        .map(key -> new ViewItem("Parameter", key.name(), key.robot(), () -> atSurface(s -> s.find(key))))
        .toList();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter, F2", "Edit, or expand a namespace"),
        new ViewKey("Ctrl+Z", "Undo the last change"),
        new ViewKey("F5", "Read all again"),
        new ViewKey("Ctrl+F, /", "Filter"));
  }
}
