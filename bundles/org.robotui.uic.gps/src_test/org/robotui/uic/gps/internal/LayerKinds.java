package org.robotui.uic.gps.internal;

import java.util.List;
import org.robotui.entity.gps.internal.layer.GpsLayerType;
import org.robotui.entity.grid.internal.layer.GridLayerType;
import org.robotui.ui.layer.LayerType;

/** The kinds of layers that a product brings into the view. */
public final class LayerKinds {
  /** All of them. */
  public static final List<LayerType> ALL = List.of(new GridLayerType(), new GpsLayerType());

  private LayerKinds() {}
}
