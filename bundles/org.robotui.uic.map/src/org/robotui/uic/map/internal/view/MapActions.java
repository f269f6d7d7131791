package org.robotui.uic.map.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.robotui.ui.Icon;
import org.robotui.ui.ViewAction;

/** What the title line offers: the same objects for every control that is made. Display thread. */
public final class MapActions {
  static final String MEASURE = "measure";
  static final String GOAL = "goal";
  static final String POSE = "initial_pose";

  private final List<ViewAction> all = List.of(
      switched("follow", "Follow the robot (F)", Icon.FOLLOW, MapCanvas::following, MapCanvas::toggleFollow),
      action("fit", "Show all (0)", Icon.FIT, MapCanvas::fit),
      tool(MEASURE, "Measure (M)", Icon.RULER),
      tool(GOAL, "Send a goal (G)", Icon.TARGET),
      tool(POSE, "Set the pose (P)", Icon.POSE),
      action("layers", "Layers (L)", Icon.LAYERS, MapCanvas::openLayers));
  private Optional<MapCanvas> canvas = Optional.empty();

  /** All actions. */
  public List<ViewAction> all() {
    return all;
  }

  void connect(MapCanvas shown) {
    canvas = Optional.of(shown);
  }

  void disconnect(MapCanvas gone) {
    canvas = canvas.filter(c -> c != gone);
  }

  private ViewAction tool(String id, String label, Icon icon) {
    return switched(id, label, icon, c -> c.using(id), c -> c.toggleTool(id));
  }

  private ViewAction action(String id, String label, Icon icon, Consumer<MapCanvas> run) {
    return new ViewAction(id, label, icon.id(), Optional.empty(), () -> canvas.ifPresent(run));
  }

  private ViewAction switched(
      String id, String label, Icon icon, Predicate<MapCanvas> on, Consumer<MapCanvas> run) {
    BooleanSupplier checked = () -> canvas.filter(on).isPresent();
    return new ViewAction(id, label, icon.id(), Optional.of(checked), () -> canvas.ifPresent(run));
  }
}
