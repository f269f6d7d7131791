package org.robotui.entity.robot.internal.layer;

import java.util.List;
import java.util.Set;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.geometry.Footprint;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerType;

/** Shows the bodies of robots on maps. */
@Component(service = LayerType.class)
public final class RobotLayerType implements LayerType {
  private static final Schema SCHEMA = Schema.of(
      Setting.of("radius", new ValueType.Num(0.01, 20, "m"), 0.25, "Size of a robot whose footprint is not known."));

  @Override
  public String id() {
    return "robot";
  }

  @Override
  public String label() {
    return "Robots";
  }

  @Override
  public String help() {
    return "Shows robots from above: their outlines or circles, where they look, and their names where there are several.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Footprint.class);
  }

  @Override
  public Set<Class<? extends Data>> needs() {
    return Set.of();
  }

  @Override
  public boolean automatic() {
    return true;
  }

  @Override
  public int level() {
    return 700;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    return new RobotLayer();
  }
}
