package org.robotui.rfic.gazebo.internal.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.data.GazeboPoses;
import org.robotui.message.data.GazeboPoses.Frames;
import org.robotui.message.data.GazeboPoses.Subject;
import org.robotui.message.ros.geometry_msgs.TransformStamped;

/**
 * What stands in a world, as its scene says: models in it, links in them, sensors on those, each with a frame. Poses
 * name things by number. Safe for all threads.
 */
public final class KnownScene {
  private static final int DEEPEST = 10;
  private static final int MOST = 20_000;

  private State state = new State(Map.of(), List.of(), List.of(), List.of());
  private long changes;
  private boolean asked;

  /** Something that looks like something, in the frame of a link. */
  record Look(String frame, DynamicRecord visual) {}

  private record State(Map<Long, Frames> frames, List<TransformStamped> fixed, List<TransformStamped> moving,
      List<Look> looks) {}

  /** Nothing is known yet. */
  public KnownScene() {
    // a scene comes when a world is asked for it
  }

  /**
   * Takes note of a scene, in the place of the one before.
   *
   * @param world the frame that models are in
   * @param scene a message of type {@code Scene}
   */
  public void take(String world, DynamicRecord scene) {
    Walk walk = new Walk();
    SceneFields.each(scene, "model").forEach(model -> walk.model(model, new Place(world, "", false, 0)));
    State now = new State(Map.copyOf(walk.frames), List.copyOf(walk.fixed), List.copyOf(walk.moving),
        List.copyOf(walk.looks));
    synchronized (this) {
      state = now;
      changes++;
    }
  }

  /**
   * How often it has changed.
   *
   * @return 0 while nothing is known
   */
  public synchronized long changes() {
    return changes;
  }

  /**
   * The frames of something.
   *
   * @param subject what a pose says of itself
   * @return its frames, or none where the scene does not have it
   */
  public synchronized Optional<Frames> frames(Subject subject) {
    Optional<Frames> known = Optional.ofNullable(state.frames().get(subject.id()));
    asked |= known.isEmpty() && subject.id() != 0;
    return known;
  }

  /** Whether somebody has asked for what is not known, since this was asked last. */
  public synchronized boolean takeAsked() {
    boolean before = asked;
    asked = false;
    return before;
  }

  /**
   * Where things were when the scene was said.
   *
   * @param fixed those that never move, or the others
   * @return transforms
   */
  public synchronized List<TransformStamped> transforms(boolean fixed) {
    return fixed ? state.fixed() : state.moving();
  }

  synchronized List<Look> looks() {
    return state.looks();
  }

  /** Where in the tree something is. */
  private record Place(String parent, String scope, boolean fixed, int depth) {
    String frame(String name) {
      return scope.isEmpty() ? name : scope + "::" + name;
    }

    Place in(String frame, boolean still) {
      return new Place(frame, frame, still, depth + 1);
    }
  }

  /** Goes through a scene once. */
  private static final class Walk {
    private final Map<Long, Frames> frames = new HashMap<>();
    private final List<TransformStamped> fixed = new ArrayList<>();
    private final List<TransformStamped> moving = new ArrayList<>();
    private final List<Look> looks = new ArrayList<>();

    void model(DynamicRecord model, Place place) {
      boolean still = place.fixed() || SceneFields.flag(model, "is_static");
      Optional<Place> in = add(model, place, place.depth() == 0 ? still : place.fixed());
      in.ifPresent(own -> {
        Place inner = own.in(own.parent(), still);
        SceneFields.each(model, "model").forEach(each -> model(each, inner));
        SceneFields.each(model, "link").forEach(each -> link(each, inner));
        look(model, own);
      });
    }

    private void link(DynamicRecord link, Place place) {
      add(link, place, place.fixed()).ifPresent(own -> {
        look(link, own);
        SceneFields.each(link, "sensor").forEach(each -> add(each, own, true));
      });
    }

    private void look(DynamicRecord what, Place own) {
      SceneFields.each(what, "visual").stream().limit(MOST - looks.size())
          .forEach(each -> looks.add(new Look(own.parent(), each)));
    }

    /** Gives something a frame; answers the place within it, or none where there is no room for it. */
    private Optional<Place> add(DynamicRecord what, Place place, boolean still) {
      String name = SceneFields.text(what, "name");
      if (name.isEmpty() || place.depth() > DEEPEST || frames.size() >= MOST) {
        return Optional.empty();
      }
      Frames own = new Frames(place.parent(), place.frame(name));
      frames.put(SceneFields.whole(what, "id"), own);
      SceneFields.inner(what, "pose").or(() -> Optional.of(SceneFields.NOTHING)).ifPresent(
          pose -> (still ? fixed : moving).add(GazeboPoses.transform(pose, own, 0)));
      return Optional.of(place.in(own.child(), still));
    }
  }
}
