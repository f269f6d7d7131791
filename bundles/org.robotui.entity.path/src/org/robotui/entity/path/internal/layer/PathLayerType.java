package org.robotui.entity.path.internal.layer;

import java.util.List;
import java.util.Optional;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.data.navigation.Path;
import org.robotui.entity.path.PathEntity;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.NewestLayer;
import org.robotui.ui.layer.SeenRobot;

/** Shows planned paths on maps. */
@Component(service = LayerType.class)
public final class PathLayerType implements LayerType {
  private static final Schema SCHEMA = Schema.of(Inks.setting("that of plans"));

  @Override
  public String id() {
    return "path";
  }

  @Override
  public String label() {
    return "Planned path";
  }

  @Override
  public String help() {
    return "Shows a planned path, and what is left to go.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Path.class);
  }

  @Override
  public boolean occasional() {
    return true;
  }

  @Override
  public int level() {
    return 500;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    PathEntity entity = new PathEntity();
    return new NewestLayer<>(Path.class, NewestLayer.When.NOW, Path::frame, entity,
        (path, place, tick) -> prepare(entity, path, place, tick),
        (path, tick) -> List.of(robot(path, tick), tick.robots().size()), () -> {});
  }

  private static LayerStatus prepare(PathEntity entity, Path path, RigidTransform place, LayerTick tick) {
    Optional<SeenRobot> robot = robot(path, tick);
    entity.ink(tick.ink());
    entity.showLabel(tick.robots().size() < 2);
    entity.prepare(path, place, robot.map(SeenRobot::at), robot.map(SeenRobot::speed).orElse(0.0));
    return new LayerStatus.Shown(path.poses().size() + " poses");
  }

  private static Optional<SeenRobot> robot(Path path, LayerTick tick) {
    return tick.robot(path.frame().robot());
  }
}
