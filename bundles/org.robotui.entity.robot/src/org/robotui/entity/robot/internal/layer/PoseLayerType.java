package org.robotui.entity.robot.internal.layer;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.entity.robot.PoseEntity;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.NewestLayer;
import org.robotui.ui.scene.Ink;

/** Shows estimates of poses on maps. */
@Component(service = LayerType.class)
public final class PoseLayerType implements LayerType {
  private static final Schema SCHEMA = Schema.of(Inks.setting("that of warnings"));

  @Override
  public String id() {
    return "pose";
  }

  @Override
  public String label() {
    return "Pose estimate";
  }

  @Override
  public String help() {
    return "Shows where localisation believes a robot to be, and how sure it is.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(PoseEstimate.class);
  }

  @Override
  public int level() {
    return 600;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    PoseEntity entity = new PoseEntity();
    return new NewestLayer<>(PoseEstimate.class, NewestLayer.When.NOW, PoseEstimate::frame, entity,
        (pose, place, tick) -> {
          entity.ink(tick.entry().ink() instanceof Ink.Chosen ? tick.ink() : Ink.USUAL);
          entity.prepare(pose, place);
          return new LayerStatus.Shown("");
        });
  }
}
