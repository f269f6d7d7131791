package org.robotui.tests.novelty;

import java.util.List;
import java.util.Set;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerType;

/** Depths as a layer, in frames and on the earth. */
final class DepthLayerType implements LayerType {
  private static final int ABOVE_ROBOTS = 900;

  @Override
  public String id() {
    return "depth";
  }

  @Override
  public String label() {
    return "Depth";
  }

  @Override
  public String help() {
    return "Shows where the depth of water was measured.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(WaterDepth.class);
  }

  @Override
  public Set<Ground> grounds() {
    return Set.of(Ground.FRAME, Ground.EARTH);
  }

  @Override
  public int level() {
    return ABOVE_ROBOTS;
  }

  @Override
  public Schema schema() {
    return Schema.EMPTY;
  }

  @Override
  public DataLayer create(LayerContext context) {
    return new DepthLayer();
  }
}
