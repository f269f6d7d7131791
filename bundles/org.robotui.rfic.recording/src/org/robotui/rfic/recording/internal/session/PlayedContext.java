package org.robotui.rfic.recording.internal.session;

import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.RficContext;
import org.robotui.api.frame.FrameSink;
import org.robotui.api.link.LinkReporter;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Offer;
import org.robotui.api.port.Offers;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.api.time.ClockSource;
import org.robotui.data.Conflation;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.marker.InteractiveMarkerSet;

/**
 * What a recording is given of core: nobody commands it, and its clock is that of the timeline, not of its topics. It
 * knows what is published, so that it can be taken back. Safe for all threads.
 *
 * @param core what core gives
 * @param streams what is published, by port
 */
record PlayedContext(RficContext core, Map<String, Stream> streams) implements RficContext, Offers {
  /** A stream, and whether its values are merged. */
  record Stream(Publication<?> publication, boolean merged) {}

  /** What is put together from several messages by who publishes it, who says each state once. */
  private static final Set<Class<?>> ONCE = Set.of(RobotDescription.class, InteractiveMarkerSet.class);
  /** The thread that follows topics knows the time a little too late. */
  private static final ClockSource SILENT = new ClockSource() {
    @Override
    public void simulated(long nanos) {
      // the timeline says it
    }

    @Override
    public void live() {
      // a recording never is
    }

    @Override
    public void observed(long stampNanos) {
      // likewise
    }
  };

  PlayedContext(RficContext core) {
    this(core, new ConcurrentHashMap<>());
  }

  @Override
  public String robot() {
    return core.robot();
  }

  @Override
  public String instance() {
    return core.instance();
  }

  @Override
  public Offers offers() {
    return this;
  }

  @Override
  public LinkReporter link() {
    return core.link();
  }

  @Override
  public ThreadFactory threads() {
    return core.threads();
  }

  @Override
  public ClockSource clock() {
    return SILENT;
  }

  @Override
  public FrameSink frames() {
    return core.frames();
  }

  @Override
  public Path stateFolder() {
    return core.stateFolder();
  }

  @Override
  public <T extends Data> Publication<T> stream(StreamPort<T> port, Demand demand) {
    Publication<T> made = core.offers().stream(port, demand);
    DataType type = port.dataType();
    if (!ONCE.contains(type.type())) {
      streams.put(port.name(), new Stream(made, type.conflation() == Conflation.KEYED));
    }
    return made;
  }

  @Override
  public <T extends Data> Offer command(CommandPort<T> port, CommandSink<T> sink) {
    return () -> {};
  }

  @Override
  public <Q, R> Offer call(CallPort<Q, R> port, CallHandler<Q, R> handler) {
    return core.offers().call(port, handler);
  }

  @Override
  public Offer browse(BrowsePort port, Browser browser) {
    return core.offers().browse(port, browser);
  }

  /** Takes back values of which each was merged with those before: they may be of a later time. */
  void forgetMerged() {
    streams.values().stream().filter(Stream::merged).forEach(each -> each.publication().forget());
  }

  /** Takes back what a stream had. */
  void forget(String port) {
    Stream stream = streams.get(port);
    if (stream != null) {
      stream.publication().forget();
    }
  }
}
