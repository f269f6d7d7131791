package org.robotui.uic.postures.internal.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.port.Caller;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.joint.JointControl;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.ask.ControlFirst;

/**
 * The postures, how hands change them, and the robot that goes through them. They are kept in the settings with each
 * change, and each change can be undone. Hands come from the display thread, ticks from the view's worker.
 */
public final class PosturesModel {
  private static final int MOST_UNDONE = 50;
  private static final double SECONDS = 3;

  private final Input<JointControl> control;
  private final Input<ControlPlugins> plugins;
  private final Caller<PluginRequest, PluginReply> caller;
  private final UicContext context;
  private final SettingsStore settings;
  private final Names names;
  private final ControlFirst first;
  private final PosturePlayer player;
  private final Deque<PostureSequence> before = new ArrayDeque<>();
  private RobotNow now;
  private volatile PosturesLook look;

  /**
   * Names of settings.
   *
   * @param plugin that follows trajectories
   * @param guide that lets joints be moved by hand
   * @param speed share of the greatest speed
   * @param loop whether the first posture follows the last one
   */
  public record Names(String plugin, String guide, String speed, String loop) {}

  /** With the ends of the ports. */
  public PosturesModel(UicContext context, Input<JointControl> control, Input<ControlPlugins> plugins,
      Caller<PluginRequest, PluginReply> caller, Names names) {
    this.control = control;
    this.plugins = plugins;
    this.caller = caller;
    this.context = context;
    this.names = names;
    settings = context.settings();
    first = new ControlFirst(context);
    player = new PosturePlayer(caller, new PosturePlayer.Wishes(settings.current().text(names.plugin()),
        settings.current().text(names.guide()), () -> settings.current().number(names.speed()),
        () -> settings.current().flag(names.loop())));
    now = RobotNow.of(control.state(), Optional.empty(), Optional.empty());
    look = picture();
  }

  /** Takes what came and goes on; whether anything is new. */
  public synchronized boolean tick(long nowNanos) {
    boolean shown = StateView.showsContent(control.state());
    now = RobotNow.of(control.state(), control.latest().map(Envelope::value).filter(c -> shown),
        plugins.latest().map(Envelope::value));
    player.tick(now, robot().flatMap(context.ruic()::authority), robot().map(first::isMine).orElse(false), nowNanos);
    return fresh();
  }

  /** What is to be shown. */
  public PosturesLook look() {
    return look;
  }

  /** The same after the user has done something; whether it differs. */
  public synchronized boolean fresh() {
    PosturesLook next = picture();
    boolean changed = !next.equals(look);
    look = next;
    return changed;
  }

  /** Whether to take over from somebody else. */
  public ControlFirst control() {
    return first;
  }

  // ---- what hands do ----------------------------------------------------------------------------------------------

  /** Keeps where the joints are now, behind the others; its key is its place. */
  public synchronized Optional<Integer> store() {
    PostureSequence sequence = sequence();
    if (!now.isLive() || now.measured().isEmpty()) {
      player.say(Health.BAD, "Not stored: the state of the joints is not known");
      return Optional.empty();
    }
    if (sequence.postures().size() >= PostureSequence.MOST) {
      player.say(Health.BAD, "Not stored: there are " + PostureSequence.MOST + " postures already");
      return Optional.empty();
    }
    Posture made = new Posture(sequence.freshName(), SECONDS, now.measured());
    change(sequence.plus(made));
    player.say(Health.OK, made.name() + " stored \u00b7 F2 names it, Ctrl+Z undoes it");
    return Optional.of(sequence.postures().size());
  }

  /** Gives a posture the present place of its joints. */
  public synchronized void again(int index) {
    find(index).filter(p -> now.isLive()).ifPresent(posture -> {
      change(sequence().with(index, posture.at(now.measured())));
      player.say(Health.OK, posture.name() + " is now where the joints are \u00b7 Ctrl+Z undoes it");
    });
  }

  /** Calls a posture otherwise. */
  public synchronized void rename(int index, String name) {
    find(index).ifPresent(posture -> change(sequence().with(index, posture.named(name))));
  }

  /** Sets how long the way to a posture takes, at least. */
  public synchronized void time(int index, double seconds) {
    find(index).ifPresent(posture -> change(
        sequence().with(index, posture.within(Math.clamp(seconds, Posture.SHORTEST, Posture.LONGEST)))));
  }

  /** Lets a posture come one earlier (-1) or later (1). */
  public synchronized void move(int index, int by) {
    find(index).ifPresent(posture -> change(sequence().moved(index, by)));
  }

  /** Removes a posture. */
  public synchronized void remove(int index) {
    find(index).ifPresent(posture -> {
      change(sequence().without(index));
      player.say(Health.OK, posture.name() + " removed \u00b7 Ctrl+Z undoes it");
    });
  }

  /** Takes the last change back. */
  public synchronized void undo() {
    Optional<PostureSequence> last = Optional.ofNullable(before.pollLast());
    last.ifPresent(sequence -> sequence.write(settings));
    player.say(Health.NONE, last.isPresent() ? "Undone" : "There is nothing to undo");
  }

  /** Takes postures of a file in place of those that are there. */
  public synchronized void take(String file, PostureText.Content content) {
    switch (content) {
      case PostureText.Content.Postures read -> {
        change(read.sequence());
        int count = read.sequence().postures().size();
        player.say(Health.OK, (count == 1 ? "1 posture" : count + " postures") + " of " + file
            + " \u00b7 Ctrl+Z undoes it");
      }
      case PostureText.Content.Unreadable not -> player.say(Health.BAD, "Not taken, " + file + ": " + not.why());
    }
  }

  /** Says what became of something. */
  public void say(Health health, String words) {
    player.say(health, words);
  }

  /** The postures as they are now. */
  public PostureSequence sequence() {
    return PostureSequence.read(settings.current());
  }

  // ---- what the robot does ----------------------------------------------------------------------------------------

  /** Has the robot go through all from one on. */
  public void play(int from) {
    command(() -> player.play(sequence().postures(), from));
  }

  /** Has the robot go to one alone. */
  public void goTo(int index) {
    command(() -> find(index).ifPresent(posture -> player.play(List.of(posture), 0)));
  }

  /** Lets joints be moved by hand, or no more. */
  public void guide(boolean wanted) {
    command(() -> player.guide(wanted));
  }

  /** Ends what the robot does with them. */
  public void stop() {
    player.stop();
  }

  private void command(Runnable action) {
    robot().ifPresentOrElse(robot -> first.with(robot, action, () -> {}),
        () -> player.say(Health.BAD, "No control is connected that follows trajectories"));
  }

  private Optional<String> robot() {
    return caller.targets().stream().findFirst().map(target -> target.component());
  }

  private Optional<Posture> find(int index) {
    List<Posture> postures = sequence().postures();
    return index >= 0 && index < postures.size() ? Optional.of(postures.get(index)) : Optional.empty();
  }

  private void change(PostureSequence next) {
    PostureSequence last = sequence();
    if (!next.equals(last)) {
      before.addLast(last);
      if (before.size() > MOST_UNDONE) {
        before.removeFirst();
      }
      next.write(settings);
    }
  }

  private PosturesLook picture() {
    PlayerLook played = player.look();
    List<Posture> postures = sequence().postures();
    List<PostureLine> lines = IntStream.range(0, postures.size())
        .mapToObj(i -> PostureLine.of(i, postures.get(i), now, played)).toList();
    String guide = settings.current().text(names.guide());
    Optional<Boolean> guiding = now.plugin(guide).filter(p -> player.isConnected()).map(p -> now.isRunning(guide));
    return new PosturesLook(control.state(), lines, played.isPlaying(), blocked(lines), guiding,
        settings.current().flag(names.loop()), settings.current().number(names.speed()), played.health(),
        played.words(), first.question());
  }

  private Optional<String> blocked(List<PostureLine> lines) {
    String plugin = settings.current().text(names.plugin());
    Optional<String> stopped = robot().flatMap(context.ruic()::authority).flatMap(Authority::stoppedBy)
        .map(by -> "The robot is stopped by " + by.label());
    if (stopped.isPresent()) {
      return stopped;
    }
    if (!player.isConnected()) {
      return Optional.of("No control is connected that follows trajectories");
    }
    if (!now.isLive()) {
      return Optional.of("The state of the joints is not known");
    }
    return now.plugin(plugin).isEmpty()
        ? Optional.of("The control has no plugin " + plugin + ": add it to its configuration")
        : lines.isEmpty() ? Optional.of("There are no postures: store one") : Optional.empty();
  }
}
