package org.robotui.rfic.xbot.internal.task;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robotui.data.FrameId;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarker.Control;
import org.robotui.data.marker.InteractiveMarker.MenuEntry;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** One task with its handle: where a user wants it, what is planned for that, and what became of it. One thread. */
final class HandledTask {
  /** Where feedback is sent. */
  static final String TOPIC = "task_handles";
  /** Entries of the menu. */
  static final int MOVE = 1;
  static final int BACK = 2;

  /** After so long what the plugin says is of the order that it was given. */
  private static final long SETTLED = TimeUnit.MILLISECONDS.toNanos(300);
  private static final double STEP = 2e-4;
  private static final double TURN_STEP = 1e-3;

  private final String robot;
  private final HandleLook look;
  private FrameTask task;
  private String off = "";
  private String status = "";
  private RigidTransform place = RigidTransform.IDENTITY;
  private Optional<RigidTransform> target = Optional.empty();
  private Optional<MotionPlan> plan = Optional.empty();
  private boolean sent;
  private long sentAt;
  private String refusal = "";

  /**
   * How a plugin is.
   *
   * @param off why its task cannot be moved; empty where it can
   * @param status what it says
   */
  record Plugin(String off, String status) {}

  HandledTask(FrameTask task, String robot) {
    this.task = task;
    this.robot = robot;
    this.look = new HandleLook(robot);
  }

  FrameTask task() {
    return task;
  }

  Optional<RigidTransform> target() {
    return target;
  }

  Optional<MotionPlan> plan() {
    return plan;
  }

  boolean isSent() {
    return sent;
  }

  boolean isOn() {
    return off.isEmpty();
  }

  /**
   * How it is now.
   *
   * @param now as its plugin says
   * @param at where its frame is
   * @param plugin how its plugin is
   * @param nanos the time
   */
  void look(FrameTask now, RigidTransform at, Plugin plugin, long nanos) {
    task = now;
    off = plugin.off();
    status = plugin.status();
    double[] moved = Twists.difference(place, at);
    if (Twists.metres(moved) > STEP || Twists.radians(moved) > TURN_STEP) {
      place = at;
    }
    boolean arrived = sent && nanos - sentAt > SETTLED && now.phase() == FrameTask.Phase.THERE;
    if (!off.isEmpty() || arrived) {
      forget();
    }
  }

  /** A user wants it there. */
  void aim(RigidTransform wanted, MotionPlan planned) {
    target = Optional.of(wanted);
    plan = Optional.of(planned);
    sent = false;
    refusal = "";
  }

  /** It was sent there; or not, and why. */
  void sent(String why, long nanos) {
    sent = why.isEmpty();
    sentAt = nanos;
    refusal = why;
  }

  /** Nothing is wanted any more. */
  void forget() {
    target = Optional.empty();
    plan = Optional.empty();
    sent = false;
    refusal = "";
  }

  /** As it is shown. */
  InteractiveMarker marker() {
    return new InteractiveMarker(task.key(), words(), TOPIC, new FrameId(robot, task.base()), Optional.empty(),
        target.orElse(place), HandleLook.SCALE, menu(), controls());
  }

  private List<Control> controls() {
    if (!isOn()) {
      return List.of(look.grey());
    }
    List<Control> controls = new ArrayList<>(look.grips(task));
    plan.filter(p -> !p.reaches()).ifPresent(p -> controls.add(look.missing(end(p))));
    if (plan.isPresent() && !sent) {
      controls.add(look.button());
    }
    return controls;
  }

  private Vector3 end(MotionPlan missed) {
    return target.orElse(place).inverse().apply(missed.end().translation());
  }

  private List<MenuEntry> menu() {
    if (!isOn() || target.isEmpty()) {
      return List.of();
    }
    return sent ? List.of(new MenuEntry(BACK, 0, "Stop (Esc)"))
        : List.of(new MenuEntry(MOVE, 0, "Move (Enter)"), new MenuEntry(BACK, 0, "Take back (Esc)"));
  }

  private String words() {
    String label = task.label();
    if (!isOn()) {
      return off;
    }
    if (!refusal.isEmpty()) {
      return label + " was not moved: " + refusal;
    }
    if (sent) {
      return task.name().isEmpty() ? label + ": " + status : status;
    }
    return plan.map(p -> label + ": " + (p.reaches() ? String.format(Locale.ROOT, "planned, %.1f s", p.seconds())
        : p.shortfall()) + ". Enter moves, Esc takes back").orElse(label);
  }

  /** An order to go to the target. */
  Optional<String> order() {
    return target.map(t -> {
      Vector3 to = t.translation();
      Quaternion turn = t.rotation();
      double[] angles = Twists.rollPitchYaw(turn);
      return task.order("pose", String.format(Locale.ROOT, "%.6f %.6f %.6f %.6f %.6f %.6f", to.x(), to.y(), to.z(),
          angles[0], angles[1], angles[2]));
    });
  }
}
