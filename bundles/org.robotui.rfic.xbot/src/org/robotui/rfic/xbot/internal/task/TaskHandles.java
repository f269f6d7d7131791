package org.robotui.rfic.xbot.internal.task;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.robotui.api.port.CommandSink;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.geometry.RigidTransform;
import org.robotui.rfic.xbot.internal.follow.FollowLink;
import org.robotui.urdf.RobotModel;
import org.robotui.xbot.Answer;
import org.robotui.xbot.Board;
import org.robotui.xbot.StateFrame;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Handles for the tasks of all Cartesian plugins. What a user drags is planned and shown; the plugin is told when the
 * user says so. Who may command was checked before, by the arbiter. The control is asked on a thread of its own.
 */
public final class TaskHandles implements CommandSink<MarkerFeedback>, AutoCloseable {
  private static final String PLUGINS = "Cartesian";
  private static final int MOST_FEEDBACK = 1_000;
  private static final long TURN_MILLIS = 50;
  private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
  private static final Logger LOG = LoggerFactory.getLogger(TaskHandles.class);

  private final String robot;
  private final RobotModel model;
  private final FollowLink link;
  private final HandleSite site;
  private final BlockingQueue<MarkerFeedback> feedback = new LinkedBlockingQueue<>(MOST_FEEDBACK);
  private final Map<String, HandledTask> handles = new LinkedHashMap<>();
  private final Map<String, TaskAnswer> answers = new LinkedHashMap<>();
  private final Set<String> known = new HashSet<>();
  private final Thread worker;
  private final LongSupplier clock;
  private Map<String, Double> positions = Map.of();
  private Optional<InteractiveMarkerSet> told = Optional.empty();
  private Optional<MotionPlan> shown = Optional.empty();
  private long lookedAt;

  /**
   * Of a robot.
   *
   * @param robot its name
   * @param model what it is made of
   * @param link to its control
   * @param site where handles and plans are shown
   * @param threads for the one thread
   */
  public TaskHandles(String robot, RobotModel model, FollowLink link, HandleSite site, ThreadFactory threads) {
    this(robot, model, link, site, threads, System::nanoTime);
  }

  TaskHandles(String robot, RobotModel model, FollowLink link, HandleSite site, ThreadFactory threads,
      LongSupplier clock) {
    this.clock = clock;
    this.lookedAt = clock.getAsLong() - LOOK_NANOS;
    this.robot = robot;
    this.model = model;
    this.link = link;
    this.site = site;
    site.plan(MotionPlan.none(model.name()));
    worker = threads.newThread(this::work);
    worker.start();
  }

  @Override
  public Sent send(MarkerFeedback said) {
    return feedback.offer(said) ? new Sent.Out() : new Sent.Refused("the control is too slow in answering");
  }

  private void work() {
    try {
      while (!Thread.currentThread().isInterrupted()) {
        List<MarkerFeedback> said = await();
        if (site.wanted() || !said.isEmpty()) {
          turn(said);
        }
      }
    } catch (InterruptedException e) {
      LOG.debug("nobody handles tasks any more");
    }
  }

  private List<MarkerFeedback> await() throws InterruptedException {
    List<MarkerFeedback> said = new ArrayList<>();
    Optional.ofNullable(feedback.poll(TURN_MILLIS, TimeUnit.MILLISECONDS)).ifPresent(said::add);
    feedback.drainTo(said);
    return said;
  }

  /** Looks how the tasks are, does what a user said, and shows what has changed. */
  void turn(List<MarkerFeedback> said) {
    if (clock.getAsLong() - lookedAt >= LOOK_NANOS) {
      lookedAt = clock.getAsLong();
      ask();
    }
    look();
    for (int i = 0; i < said.size(); i++) {
      take(said.get(i), isOverwritten(said, i));
    }
    show();
  }

  /** Whether the pose of a feedback is that of a hand that has moved on since. */
  private static boolean isOverwritten(List<MarkerFeedback> said, int index) {
    MarkerFeedback one = said.get(index);
    return said.subList(index + 1, said.size()).stream()
        .anyMatch(later -> later.marker().equals(one.marker()) && later.event() == MarkerFeedback.Event.POSE_UPDATE);
  }

  private void ask() {
    answers.clear();
    for (Board.Plugin plugin : link.plugins()) {
      if (plugin.type().startsWith(PLUGINS)) {
        Answer answer = link.ask("tasks " + plugin.name());
        if (answer.ok()) {
          TaskAnswer.read(plugin.name(), answer.text()).ifPresent(tasks -> answers.put(plugin.name(), tasks));
        }
      }
    }
  }

  private void look() {
    positions = positions();
    Set<String> there = new HashSet<>();
    for (Board.Plugin plugin : link.plugins()) {
      TaskAnswer answer = answers.get(plugin.name());
      if (plugin.state() == Board.PluginState.RUNNING) {
        known.add(plugin.name());
      }
      if (answer != null && known.contains(plugin.name())) {
        TaskArm arm = arm(answer);
        answer.tasks().stream().filter(arm::knows).forEach(task -> {
          there.add(task.key());
          look(plugin, task, arm.pose(task, arm.start()));
        });
      }
    }
    handles.keySet().retainAll(there);
  }

  private void look(Board.Plugin plugin, FrameTask task, RigidTransform place) {
    HandledTask handle = handles.computeIfAbsent(task.key(), key -> new HandledTask(task, robot));
    boolean runs = plugin.state() == Board.PluginState.RUNNING;
    String off = !runs ? plugin.name() + " is stopped" + (plugin.error().isEmpty() ? "" : ": " + plugin.error())
        : task.phase() == FrameTask.Phase.DISABLED ? task.label() + " is disabled" : "";
    handle.look(task, place, new HandledTask.Plugin(off, plugin.status()), clock.getAsLong());
  }

  private Map<String, Double> positions() {
    List<String> names = link.joints();
    List<StateFrame.Joint> joints = link.state().map(StateFrame::joints).orElse(List.of());
    Map<String, Double> now = new HashMap<>();
    for (int i = 0; i < Math.min(names.size(), joints.size()); i++) {
      now.put(names.get(i), joints.get(i).linkPosition());
    }
    return now;
  }

  private TaskArm arm(TaskAnswer answer) {
    List<String> names = link.joints();
    return new TaskArm(model, answer.joints().stream().filter(i -> i >= 0 && i < names.size()).map(names::get).toList(),
        positions);
  }

  private void take(MarkerFeedback said, boolean overwritten) {
    HandledTask handle = handles.get(said.marker());
    if (handle == null || !handle.isOn()) {
      return;
    }
    switch (said.event()) {
      case POSE_UPDATE -> {
        if (!overwritten && said.frame().name().equals(handle.task().base())) {
          plan(handle, said.pose());
        }
      }
      case BUTTON_CLICK -> move(handle);
      case MENU_SELECT -> {
        if (said.menuEntry() == HandledTask.MOVE) {
          move(handle);
        } else if (said.menuEntry() == HandledTask.BACK) {
          takeBack(handle);
        }
      }
      case MOUSE_DOWN, MOUSE_UP, KEEP_ALIVE -> {}
    }
  }

  private void plan(HandledTask handle, RigidTransform wanted) {
    double length = wanted.rotation().norm();
    TaskAnswer answer = answers.get(handle.task().plugin());
    if (answer == null || !wanted.translation().isFinite() || !(length > 0) || !Double.isFinite(length)) {
      return;
    }
    RigidTransform target = new RigidTransform(wanted.translation(), wanted.rotation().normalized());
    TaskArm arm = arm(answer);
    List<FrameTask> active = answer.tasks().stream()
        .filter(task -> task.phase() != FrameTask.Phase.DISABLED && arm.knows(task)).toList();
    handle.aim(target, TaskPlanner.plan(arm, handle.task(), target, active));
    shown = handle.plan();
    site.plan(shown.orElseThrow().displayed(model.name()));
  }

  private void move(HandledTask handle) {
    if (handle.isSent()) {
      return;
    }
    handle.order().ifPresent(order -> {
      Answer answer = link.ask("command " + handle.task().plugin() + " " + order);
      handle.sent(answer.ok() ? "" : answer.text(), clock.getAsLong());
    });
  }

  private void takeBack(HandledTask handle) {
    if (handle.isSent()) {
      link.ask("command " + handle.task().plugin() + " " + handle.task().order("stop", ""));
    }
    handle.forget();
  }

  private void show() {
    if (shown.isPresent() && handles.values().stream().noneMatch(handle -> handle.plan().equals(shown))) {
      shown = Optional.empty();
      site.plan(MotionPlan.none(model.name()));
    }
    InteractiveMarkerSet now = new InteractiveMarkerSet(true,
        handles.values().stream()
            .map(handle -> new InteractiveMarkerSet.Entry(handle.task().key(), Optional.of(handle.marker())))
            .toList());
    if (!told.equals(Optional.of(now))) {
      told = Optional.of(now);
      site.handles(now);
    }
  }

  @Override
  public void close() {
    worker.interrupt();
  }
}
