package org.robotui.uic.map.internal.view;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Painter;
import org.robotui.uic.map.internal.model.MapSnapshot;
import org.robotui.uic.map.internal.model.Team;

/**
 * Where the robots of a team were sent, each until it is there, the fixed frame is another, or the user is done with
 * it. Display thread.
 */
final class TeamMarks {
  private static final double NEAR = 0.5;
  private static final double RING = 7;
  private static final double CORE = 2.5;
  private static final double QUIET = 0.8;

  private final Team team;
  private final Map<String, RigidTransform> spots = new LinkedHashMap<>();
  private Optional<FrameId> frame = Optional.empty();

  TeamMarks(Team team) {
    this.team = team;
  }

  void add(FrameId fixed, Map<String, RigidTransform> sent) {
    if (!frame.equals(Optional.of(fixed))) {
      spots.clear();
      frame = Optional.of(fixed);
    }
    spots.putAll(sent);
  }

  void clear() {
    spots.clear();
  }

  /** The robots that are on their way. */
  Map<String, RigidTransform> look(MapSnapshot snapshot) {
    if (!snapshot.fixed().equals(frame)) {
      spots.clear();
    }
    snapshot.robots().forEach(r -> Optional.ofNullable(spots.get(r.name())).map(RigidTransform::translation)
        .filter(spot -> near(spot, r.fixedFromBase().translation())).ifPresent(spot -> spots.remove(r.name())));
    return spots;
  }

  private static boolean near(Vector3 a, Vector3 b) {
    return a.minus(b).norm() < NEAR;
  }

  void paint(Painter painter, MapSnapshot snapshot) {
    look(snapshot).forEach((robot, spot) -> {
      Color color = painter.theme().traces().get(team.number(robot) % painter.theme().traces().size());
      painter.opacity(QUIET).stroke(color).fill(color).width(2);
      painter.circle(spot.translation().x(), spot.translation().y(), RING);
      painter.disc(spot.translation().x(), spot.translation().y(), CORE);
    });
    painter.opacity(1);
  }
}
