package org.robotui.uic.scene3d.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.gl.display.Places;
import org.robotui.ui.scene.Placer;

/** Where frames are, for displays: found as on the map. */
final class ScenePlaces implements Places {
  private final Frames frames;
  private final Placer placer;

  ScenePlaces(Frames frames, FrameId fixed) {
    this.frames = frames;
    placer = new Placer(frames, fixed);
  }

  @Override
  public FrameId fixed() {
    return placer.fixed();
  }

  @Override
  public Place at(FrameId frame, Optional<Stamp> stamp) {
    return switch (placer.at(frame, stamp)) {
      case Placer.Placement.At at -> new Place.At(at.transform());
      case Placer.Placement.Missing missing -> new Place.Missing(missing.reason());
    };
  }

  @Override
  public List<FrameId> all() {
    return frames.all();
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return frames.parent(frame);
  }
}
