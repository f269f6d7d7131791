package org.robotui.entity.marker.internal;

import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;

/** Where a marker's frame is. Markers with equal spots can be drawn together. */
sealed interface Spot {
  /** It moves with its frame. */
  record With(FrameId frame) implements Spot {}

  /** It stays where its frame was. */
  record Still(RigidTransform fixedFromFrame) implements Spot {}
}
