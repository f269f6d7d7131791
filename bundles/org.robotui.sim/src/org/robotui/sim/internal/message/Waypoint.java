package org.robotui.sim.internal.message;

import java.util.List;
import java.util.function.Consumer;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerFeedback;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerPose;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerUpdate;
import org.robotui.sim.internal.Event;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

/**
 * Serves an interactive marker: a waypoint that users move over the floor of the building, and to which the robot
 * drives when they choose so in its menu. Locked, as feedback comes on threads of its links.
 */
final class Waypoint {
  private static final double AHEAD = 1;

  private final World world;
  private final Places places;
  private final Consumer<PoseStamped> drive;
  private final Consumer<Event> events;
  private final String server;
  private final MessageSink<InteractiveMarkerUpdate> update;
  private final Runnable all;
  private Pose2 place;
  private long number;

  /** @param drive takes a goal */
  Waypoint(MessageNode node, World world, Places places, Consumer<PoseStamped> drive, Consumer<Event> events) {
    this.world = world;
    this.places = places;
    this.drive = drive;
    this.events = events;
    server = "/" + node.name() + "/waypoint";
    place = world.start().times(new Pose2(AHEAD, 0, 0));
    update = node.topic("waypoint/update", InteractiveMarkerUpdate.class, TopicKind.STATE);
    all = node.markers("waypoint", this::everything);
    node.listen("waypoint/feedback", InteractiveMarkerFeedback.class, this::take);
  }

  private synchronized InteractiveMarkerInit everything() {
    return new InteractiveMarkerInit(server, number, List.of(WaypointMarker.message(place)));
  }

  private synchronized void take(InteractiveMarkerFeedback feedback) {
    if (!feedback.markerName().equals(WaypointMarker.NAME)) {
      return;
    }
    switch (feedback.eventType()) {
      case InteractiveMarkerFeedback.POSE_UPDATE -> follow(feedback);
      case InteractiveMarkerFeedback.MENU_SELECT -> choose((int) feedback.menuEntryId());
      default -> {}
    }
  }

  private void follow(InteractiveMarkerFeedback feedback) {
    Places.Found found = places.inMap(feedback.header().frameId(), feedback.pose());
    found.pose().ifPresentOrElse(this::move,
        () -> events.accept(new Event(Event.Severity.WARN, "commands", "waypoint not moved: " + found.problem())));
  }

  /** It stays within the building, whatever is asked; the update says where it is then. */
  private void move(Pose2 wish) {
    if (world.roomAt(wish.x(), wish.y()).isPresent()) {
      place = wish;
    }
    number++;
    InteractiveMarkerPose pose =
        new InteractiveMarkerPose(new Header(0, 0, Frames.MAP), Poses.pose(place), WaypointMarker.NAME);
    update.send(new InteractiveMarkerUpdate(server, number, InteractiveMarkerUpdate.UPDATE, List.of(), List.of(pose),
        List.of()));
    all.run();
  }

  private void choose(int entry) {
    switch (entry) {
      case WaypointMarker.GO -> drive.accept(new PoseStamped(new Header(0, 0, Frames.MAP), Poses.pose(place)));
      case WaypointMarker.TO_ROBOT -> move(places.robot().get().estimate());
      default -> events.accept(new Event(Event.Severity.WARN, "commands", "waypoint has no menu entry " + entry));
    }
  }

  /** Lets clients see that it is there, and that they missed nothing. */
  synchronized void publish(long step) {
    if (Rate.SIGN_OF_LIFE.isDue(step)) {
      update.send(new InteractiveMarkerUpdate(server, number, InteractiveMarkerUpdate.KEEP_ALIVE, List.of(),
          List.of(), List.of()));
    }
  }
}
