package org.robotui.entity.laserscan.internal.layer;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.sensor.LaserScan;
import org.robotui.entity.laserscan.LaserScanEntity;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.NewestLayer;

/** Shows laser scans on maps. */
@Component(service = LayerType.class)
public final class LaserScanLayerType implements LayerType {
  /** The free space of more robots would cover the floor. */
  private static final int MOST_FANS = 4;

  private static final Schema SCHEMA = Schema.of(
      Inks.setting("that of lasers"),
      Setting.of("size", new ValueType.Num(1, 40, "px"), 4.0, "Edge of an echo."),
      Setting.of("free_space", new ValueType.Flag(), true,
          "Whether the free space that the beams crossed is shown, where there are four robots at most."));

  @Override
  public String id() {
    return "scan";
  }

  @Override
  public String label() {
    return "Laser scan";
  }

  @Override
  public String help() {
    return "Shows the newest laser scan, and the free space that its beams crossed.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(LaserScan.class);
  }

  @Override
  public int level() {
    return 300;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    LaserScanEntity entity = new LaserScanEntity();
    return new NewestLayer<>(LaserScan.class, NewestLayer.When.MEASURED, LaserScan::frame, entity,
        (scan, place, tick) -> prepare(entity, scan, place, tick), (scan, tick) -> fan(tick), () -> {});
  }

  private static LayerStatus prepare(LaserScanEntity entity, LaserScan scan, RigidTransform place, LayerTick tick) {
    entity.showFan(fan(tick));
    entity.ink(tick.ink());
    entity.size(tick.settings().number("size"));
    entity.prepare(scan, place);
    return new LayerStatus.Shown(entity.echoes() + " echoes");
  }

  private static boolean fan(LayerTick tick) {
    return tick.settings().flag("free_space") && tick.robots().size() <= MOST_FANS;
  }
}
