package org.robotui.entity.odometry.internal.display;

import java.util.List;
import java.util.Set;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.StampedPose;
import org.robotui.entity.odometry.internal.colored.ColorBy;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows a pose as an arrow or axes. */
@Component(service = DisplayType.class)
public final class StampedPoseType implements DisplayType {
  private static final Schema SCHEMA = PoseSettings.schema("#b86bff", 1, 0.6);

  @Override
  public String id() {
    return "stampedpose";
  }

  @Override
  public String label() {
    return "Pose";
  }

  @Override
  public String help() {
    return "Shows a pose as an arrow or axes.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(StampedPose.class);
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
    return new PoseTrailDisplay<>(StampedPose.class, pose -> Doubles.EMPTY, context);
  }
}
