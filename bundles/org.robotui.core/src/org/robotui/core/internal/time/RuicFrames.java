package org.robotui.core.internal.time;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.LongSupplier;
import org.robotui.api.frame.FrameLink;
import org.robotui.api.frame.FrameRefusal;
import org.robotui.api.frame.FrameSink;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.geometry.TransformBuffer;
import org.robotui.geometry.TransformLookup;
import org.robotui.geometry.TransformPut;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The frames of all robots of one RUIC. */
public final class RuicFrames implements Frames, FrameSink {
  private static final Logger LOG = LoggerFactory.getLogger(RuicFrames.class);
  private static final int LOGGED = 20;
  private static final String CONFIGURATION = "the configuration";

  private final AtomicReference<TransformBuffer<FrameId>> buffer = new AtomicReference<>(new TransformBuffer<>());
  private final AtomicReference<FrameLedger> ledger = new AtomicReference<>();
  private final AtomicLong refused = new AtomicLong();
  private final LongSupplier clock;
  private volatile TransformSet configured;

  /**
   * With the clock of this machine.
   *
   * @param configured how robots stand to one another: fixed, and known whatever is forgotten
   */
  public RuicFrames(List<FrameTransform> configured) {
    this(configured, System::nanoTime);
  }

  RuicFrames(List<FrameTransform> configured, LongSupplier clock) {
    this.configured = new TransformSet(configured);
    this.clock = clock;
    reset();
  }

  @Override
  public void add(TransformSet transforms, String authority) {
    TransformBuffer<FrameId> into = buffer.get();
    for (FrameTransform t : transforms.transforms()) {
      TransformPut<FrameId> put = t.fixed()
          ? into.putStatic(t.parent(), t.child(), t.parentFromChild(), authority)
          : into.put(t.parent(), t.child(), t.stamp().nanos(), t.parentFromChild(), authority);
      switch (put) {
        case TransformPut.Refused<FrameId> r -> refuse(r.reason(), authority);
        case TransformPut.Accepted<FrameId> a -> ledger.get().taken(t, authority);
      }
    }
  }

  private void refuse(String reason, String authority) {
    ledger.get().refused(reason, authority);
    long count = refused.incrementAndGet();
    if (count <= LOGGED) {
      LOG.warn("Refused of {}: {}{}", authority, reason, count == LOGGED ? "; further ones are only counted" : "");
    }
  }

  /** How many transforms were refused. */
  public long refused() {
    return refused.get();
  }

  /** The time has jumped back: what was known lies in the future now. Fixed transforms stay true. */
  public void clear() {
    buffer.get().clear();
    ledger.get().clear();
  }

  /** Has robots stand to one another otherwise, and forgets all that they said. */
  public void configure(List<FrameTransform> anew) {
    configured = new TransformSet(anew);
    reset();
  }

  /** Forgets really all that robots said: new instances will say it again. */
  public void reset() {
    buffer.set(new TransformBuffer<>());
    ledger.set(new FrameLedger(clock));
    add(configured, CONFIGURATION);
  }

  @Override
  public TransformLookup<FrameId> lookup(FrameId target, FrameId source, Optional<Stamp> stamp) {
    TransformBuffer<FrameId> from = buffer.get();
    return stamp.map(s -> from.lookup(target, source, s.nanos())).orElseGet(() -> from.lookupLatest(target, source));
  }

  @Override
  public List<FrameId> all() {
    return buffer.get().frames().stream()
        .sorted(Comparator.comparing(FrameId::robot).thenComparing(FrameId::name)).toList();
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return buffer.get().parentOf(frame);
  }

  @Override
  public List<FrameLink> links() {
    return ledger.get().links(buffer.get().edges());
  }

  @Override
  public List<FrameRefusal> refusals() {
    return ledger.get().refusals();
  }
}
