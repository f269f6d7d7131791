package org.robotui.uic.map.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.InputState;
import org.robotui.data.FrameId;
import org.robotui.geometry.Vector3;
import org.robotui.ui.layer.LayerNote;
import org.robotui.ui.layer.SeenRobot;

/**
 * What the canvas paints besides the layers.
 *
 * @param fixed what is drawn at rest; none while no frame is known
 * @param frames all that could be chosen instead
 * @param state of the inputs as a whole
 * @param notes what layers have to say
 * @param robots where they are, the one of the map's commands first
 * @param ways where the ways end that robots plan; none where nothing tells what they plan
 * @param failures of goals, the newest of each source
 * @param selected the robots that the user means
 * @param past where robots were at the time at which the user points
 */
public record MapSnapshot(
    Optional<FrameId> fixed, List<FrameId> frames, InputState state, List<LayerNote> notes, List<SeenRobot> robots,
    Optional<List<Vector3>> ways, List<GoalFailure> failures, Set<String> selected,
    List<PastPlace> past) {
  /** Before the first tick. */
  public static final MapSnapshot NONE = new MapSnapshot(
      Optional.empty(), List.of(), new InputState.Waiting("The map has not looked for data yet."), List.of(), List.of(),
      Optional.empty(), List.of(), Set.of(), List.of());
}
