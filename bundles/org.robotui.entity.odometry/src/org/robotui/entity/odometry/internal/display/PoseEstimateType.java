package org.robotui.entity.odometry.internal.display;

import java.util.List;
import java.util.Set;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.entity.odometry.internal.colored.ColorBy;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows where a robot is believed to be, and how surely. */
@Component(service = DisplayType.class)
public final class PoseEstimateType implements DisplayType {
  private static final Schema SCHEMA = PoseSettings.schema("#3ea6ff", 1, 0.6);

  @Override
  public String id() {
    return "pose";
  }

  @Override
  public String label() {
    return "Pose with covariance";
  }

  @Override
  public String help() {
    return "Shows an estimated pose and its covariance.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(PoseEstimate.class);
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
    return new PoseTrailDisplay<>(PoseEstimate.class, PoseEstimate::covariance, context);
  }
}
