package org.robotui.entity.odometry.internal.display;

import java.util.List;
import java.util.Set;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.navigation.Odometry;
import org.robotui.entity.odometry.internal.colored.ColorBy;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows the way that a robot has gone, as arrows. */
@Component(service = DisplayType.class)
public final class OdometryType implements DisplayType {
  private static final Schema SCHEMA = PoseSettings.schema("#f76b15", 100, 0.3);

  @Override
  public String id() {
    return "odometry";
  }

  @Override
  public String label() {
    return "Odometry";
  }

  @Override
  public String help() {
    return "Shows the odometry of a robot: the path it has travelled, as arrows.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Odometry.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Set<SourceId> also(Settings settings) {
    return ColorBy.source(settings);
  }

  @Override
  public Display create(DisplayContext context) {
    return new PoseTrailDisplay<>(Odometry.class, Odometry::poseCovariance, context);
  }
}
