package org.robotui.uic.gps.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.ui.layer.LayerType;
import org.robotui.uic.gps.internal.model.GpsModel;
import org.robotui.uic.gps.internal.view.GpsActions;
import org.robotui.uic.gps.internal.view.GpsCanvas;
import org.robotui.uic.gps.internal.view.GpsChoices;

/** Satellite positions: the model is prepared by ticks, the canvas paints it. */
final class GpsUic implements SwtUic {
  private final GpsModel model;
  private final GpsChoices choices;
  private final GpsActions actions = new GpsActions();
  private Optional<GpsCanvas> canvas = Optional.empty();

  GpsUic(UicContext context, Supplier<List<LayerType>> kinds) {
    model = new GpsModel(context, kinds);
    choices = new GpsChoices(context.settings());
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, choices.options());
  }

  @Override
  public Control createControl(Composite parent, UiContext context) {
    GpsCanvas made = new GpsCanvas(parent, context, model, choices, actions);
    canvas = Optional.of(made);
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("F", "Follow the receiver"),
        new ViewKey("M", "Measure"),
        new ViewKey("C", "Copy the coordinates"),
        new ViewKey("D", "Show degrees, minutes, seconds"),
        new ViewKey("L", "Open or close the list of layers"),
        new ViewKey("0", "Show all"),
        new ViewKey("+, -", "Zoom"),
        new ViewKey("Arrows", "Move"),
        new ViewKey("Esc", "End measuring"));
  }

  @Override
  public void refresh() {
    canvas.ifPresent(GpsCanvas::refresh);
  }

  @Override
  public List<ViewAction> actions() {
    return actions.all();
  }

  @Override
  public void close() {
    // What belongs to the display went with the control; there is nothing else.
  }
}
