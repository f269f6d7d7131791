package org.robotui.uic.parameters.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.view.ParametersActions;
import org.robotui.uic.parameters.internal.view.ParametersSurface;

/** The view: the model is prepared by ticks, the surface shows it. */
final class ParametersUic implements SwtUic {
  private final UicContext context;
  private final ParametersModel model;
  private final ParametersActions actions;
  private Optional<ParametersSurface> surface = Optional.empty();

  ParametersUic(UicContext context) {
    this.context = context;
    this.model = new ParametersModel(context);
    this.actions = new ParametersActions(model);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, ParametersOptions.of(context.settings().current()));
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    ParametersSurface made = new ParametersSurface(parent, ui, model);
    surface = Optional.of(made);
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter, F2", "Edit, or expand a namespace"),
        new ViewKey("Ctrl+Z", "Undo the last change"),
        new ViewKey("F5", "Read all again"),
        new ViewKey("Ctrl+F, /", "Filter"));
  }

  @Override
  public void refresh() {
    surface.ifPresent(ParametersSurface::refresh);
  }

  @Override
  public List<ViewAction> actions() {
    return actions.all();
  }

  @Override
  public void close() {
    // What runs in the background is ended by core; there is nothing else.
  }
}
