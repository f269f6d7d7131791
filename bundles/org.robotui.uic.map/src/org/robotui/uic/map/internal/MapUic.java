package org.robotui.uic.map.internal;

import java.util.List;
import java.util.function.Supplier;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.show.Subject;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.map.internal.model.MapModel;
import org.robotui.uic.map.internal.view.MapActions;
import org.robotui.uic.map.internal.view.MapCanvas;
import org.robotui.uic.map.internal.view.MapChoices;
import org.robotui.uic.map.internal.view.TeamGoals;

/** A map: the model is prepared by ticks, the canvas paints it. */
final class MapUic extends SurfaceUic<MapCanvas> {
  private final MapModel model;
  private final MapChoices choices;
  private final Commander commander;
  private final TeamGoals goals;

  MapUic(UicContext context, Supplier<List<LayerType>> kinds) {
    model = new MapModel(context, kinds);
    MapActions.offer(offers(), context.ruic()::reset);
    choices = new MapChoices(context.settings());
    goals = new TeamGoals(context);
    commander = new Commander(context, MapPorts.GOAL, MapPorts.INITIAL_POSE);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, choices.options());
  }

  @Override
  protected MapCanvas open(Composite parent, UiContext ui) {
    return new MapCanvas(parent, ui, model, choices, commander, goals);
  }

  @Override
  protected void refresh(MapCanvas shown) {
    shown.refresh();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("G", "Send a goal"),
        new ViewKey("P", "Set the pose estimate"),
        new ViewKey("M", "Measure"),
        new ViewKey("F", "Follow the robot"),
        new ViewKey("L", "Open or close the list of layers"),
        new ViewKey("0, Home", "Show all"),
        new ViewKey("+, -", "Zoom"),
        new ViewKey("Arrows", "Move"),
        new ViewKey("Esc", "End the tool"));
  }

  @Override
  public void show(String showing, Subject subject) {
    if (subject instanceof Subject.Stream stream) {
      surface().ifPresent(c -> c.show(stream.port()));
    }
  }
}
