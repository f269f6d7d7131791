package org.robotui.api.frame;

import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.TransformLookup;

/** The coordinate frames of the robots of one RUIC. Safe for all threads, never blocks. */
public interface Frames {
  /**
   * Where the source frame lies in the target frame at a time.
   *
   * @param target the frame to express things in
   * @param source the frame they are given in
   * @param stamp when; empty for the newest time at which the whole chain is known
   * @return the transform target from source, or why there is none
   */
  TransformLookup<FrameId> lookup(FrameId target, FrameId source, Optional<Stamp> stamp);

  /**
   * All frames now known.
   *
   * @return sorted by robot and name
   */
  List<FrameId> all();

  /**
   * The frame that carries another.
   *
   * @param frame a frame
   * @return its parent, or none where it is a root or unknown
   */
  Optional<FrameId> parent(FrameId frame);

  /**
   * The transforms that are held now, one for each frame that has a parent.
   *
   * @return what is known of them, in no order; empty where that is not kept
   */
  default List<FrameLink> links() {
    return List.of();
  }

  /**
   * The transforms that were not taken lately, the newest first; one entry for each reason, and at most a few.
   *
   * @return the refusals; empty where that is not kept
   */
  default List<FrameRefusal> refusals() {
    return List.of();
  }
}
