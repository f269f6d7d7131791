package org.robotui.entity.bumper.internal.layer;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.data.sensor.Bumpers;
import org.robotui.entity.bumper.BumperEntity;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.NewestLayer;

/** Shows bumpers on maps. */
@Component(service = LayerType.class)
public final class BumperLayerType implements LayerType {
  private static final Schema SCHEMA = Schema.of();

  @Override
  public String id() {
    return "bumper";
  }

  @Override
  public String label() {
    return "Bumpers";
  }

  @Override
  public String help() {
    return "Shows bumpers around a robot, and which are pressed.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Bumpers.class);
  }

  @Override
  public int level() {
    return 800;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    BumperEntity entity = new BumperEntity();
    return new NewestLayer<>(Bumpers.class, NewestLayer.When.NOW, Bumpers::frame, entity, (bumpers, place, tick) -> {
      entity.prepare(bumpers, place);
      return new LayerStatus.Shown(bumpers.bumpers().size() + " bumpers");
    });
  }
}
