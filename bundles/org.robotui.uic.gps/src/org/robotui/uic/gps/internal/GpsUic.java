package org.robotui.uic.gps.internal;

import java.util.List;
import java.util.function.Supplier;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.ui.layer.LayerType;
import org.robotui.uic.gps.internal.model.GpsModel;
import org.robotui.uic.gps.internal.view.GpsActions;
import org.robotui.uic.gps.internal.view.GpsCanvas;
import org.robotui.uic.gps.internal.view.GpsChoices;

/** Satellite positions: the model is prepared by ticks, the canvas paints it. */
final class GpsUic extends SurfaceUic<GpsCanvas> {
  private final GpsModel model;
  private final GpsChoices choices;

  GpsUic(UicContext context, Supplier<List<LayerType>> kinds) {
    model = new GpsModel(context, kinds);
    choices = new GpsChoices(context.settings());
    GpsActions.offer(offers());
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, choices.options());
  }

  @Override
  protected GpsCanvas open(Composite parent, UiContext ui) {
    return new GpsCanvas(parent, ui, model, choices);
  }

  @Override
  protected void refresh(GpsCanvas shown) {
    shown.refresh();
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
}
