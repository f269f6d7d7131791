package org.robotui.core.internal.life;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.api.frame.FrameSink;
import org.robotui.api.link.LinkReporter;
import org.robotui.api.port.Offers;
import org.robotui.api.time.ClockSource;
import org.robotui.core.internal.command.Arbiter;
import org.robotui.core.internal.command.CommandTarget;
import org.robotui.core.internal.command.Sender;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.port.CallPool;
import org.robotui.core.internal.port.Link;
import org.robotui.core.internal.time.RobotTime;
import org.robotui.core.internal.time.StampWatch;
import org.robotui.core.internal.time.TimeNotices;
import org.robotui.core.internal.watch.Watch.Watched;
import org.robotui.data.FrameId;

/** One running instance of a robot interface with all that it was given. */
final class RficInstance extends Instance implements RficContext {
  private static final Duration GRACE = Duration.ofMillis(300);
  private static final Duration FLUSH = Duration.ofMillis(100);
  private static final int ZEROS = 3;
  private static final long ZERO_SPACING_MILLIS = 50;

  private final ComponentConfig config;
  private final RficType type;
  private final Settings settings;
  private final ComponentHome ruic;
  private final Link link;
  private final Arbiter arbiter;
  private final Sender sender;
  private final CallPool calls;
  private final CallPool tasks;
  private final Background background;
  private final OfferTable offers;
  private final RobotTime clock;
  private final StampWatch stamps;
  private final Watched watched = this::check;
  private volatile Optional<Rfic> rfic = Optional.empty();
  private final FixedFrames fixed = new FixedFrames();
  private volatile boolean ended;

  RficInstance(ComponentConfig config, RficType type, Settings settings, ComponentHome ruic) {
    super(config, ruic);
    Services services = ruic.services();
    this.config = config;
    this.type = type;
    this.settings = settings;
    this.ruic = ruic;
    ThreadFactory threads = tracked();
    this.link = new Link(services.clock(), ruic.wake()::linkChanged);
    this.arbiter = services.arbiters().of(config.robot());
    this.sender = new Sender(name(), threads, services.clock());
    this.calls = new CallPool(threads);
    this.tasks = new CallPool(threads);
    this.clock = ruic.clock().source(config.id());
    this.background = tasks();
    this.stamps = new StampWatch(services.clock(), new TimeNotices(config.id(), () -> ruic.clock().jumpedBack(clock),
        what -> services.events().alert(ruic.ruicName(), what)));
    this.offers =
        new OfferTable(new RficParts(config.id(), link, arbiter, sender, calls, tasks, services.timer(), background,
            services.clock(), clock, stamps, ruic.wake()::rematch, this::origin));
  }

  @Override
  void start() throws Guarded.GuardException, InterruptedException {
    Rfic made = Guarded.call("create", tracked(), Limits.FIRST, () -> type.create(this, settings));
    rfic = Optional.of(made);
    ruic.services().watch().add(watched);
    Guarded.run("start", tracked(), Limits.FIRST, made::start);
  }

  private void check(long now) {
    sender.check(now).ifPresent(this::complain);
  }

  @Override
  Optional<Rfic> made() {
    return rfic;
  }

  @Override
  Optional<String> end(Duration limit) throws InterruptedException {
    try {
      return endAll(limit);
    } finally {
      ruic.services().watch().remove(watched);
    }
  }

  private Optional<String> endAll(Duration limit) throws InterruptedException {
    stopOurs();
    String hung = "";
    try {
      if (rfic.isPresent()) {
        Guarded.run("close", tracked(), limit, rfic.get()::close);
      }
    } catch (Guarded.GuardException e) {
      hung = e.getMessage();
    }
    ended = true;
    offers.close();
    calls.close();
    tasks.close();
    background.close();
    sender.close();
    ruic.clock().forget(clock);
    return leftAfter(hung);
  }

  private void stopOurs() throws InterruptedException {
    List<CommandTarget<?>> moving = arbiter.endNow(offers.commands());
    for (int i = 1; !moving.isEmpty() && i < ZEROS; i++) {
      sender.flush(FLUSH);
      Thread.sleep(ZERO_SPACING_MILLIS);
      moving.forEach(CommandTarget::postZero);
    }
    sender.flush(FLUSH);
  }

  private Optional<String> leftAfter(String hung) throws InterruptedException {
    boolean clean = hung.isEmpty() && tracked().awaitNone(GRACE);
    String left = clean ? "" : tracked().endAll(GRACE);
    return hung.isEmpty() && left.isEmpty() ? Optional.empty()
        : Optional.of(left(hung.isEmpty() ? "has ended" + left : hung + left));
  }

  @Override
  RficType type() {
    return type;
  }

  OfferTable table() {
    return offers;
  }

  Link linkNow() {
    return link;
  }

  @Override
  public String robot() {
    return config.robot();
  }

  @Override
  public Offers offers() {
    return offers;
  }

  @Override
  public LinkReporter link() {
    return link;
  }

  @Override
  public ThreadFactory threads() {
    return tracked();
  }

  @Override
  public ClockSource clock() {
    return clock;
  }

  @Override
  public Path stateFolder() {
    return ruic.services().stateFolder().resolve(type.id());
  }

  /** What an instance that was given up still says is not mixed into the frames of the one that took its place. */
  @Override
  public FrameSink frames() {
    return (transforms, authority) -> {
      if (!ended) {
        fixed.remember(transforms, authority);
        transforms.transforms().stream().filter(t -> !t.fixed())
            .forEach(t -> stamps.heard(new FrameVoice(t.child(), authority), t.stamp()));
        ruic.frames().add(transforms, authority);
      }
    };
  }

  private record FrameVoice(FrameId frame, String authority) {
    @Override
    public String toString() {
      return "frame " + frame.name() + (authority.isEmpty() ? "" : " (" + authority + ")");
    }
  }

  /** All frames were forgotten: what holds for all times is said but once by robots. */
  void sayFixedFramesAgain() {
    fixed.sayAgain(ruic.frames());
  }
}
