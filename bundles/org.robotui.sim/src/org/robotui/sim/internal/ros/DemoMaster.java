package org.robotui.sim.internal.ros;

import java.io.IOException;
import java.net.URI;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;

/** The master of simulated robots: one of their own, on loopback, unless there is a real one. */
public final class DemoMaster implements AutoCloseable {
  private final Optional<RosMaster> own;
  private final URI uri;

  private DemoMaster(Optional<RosMaster> own, URI uri) {
    this.own = own;
    this.uri = uri;
  }

  /**
   * Opens one where there is none.
   *
   * @param options say which
   * @param threads of the own one
   * @throws IOException if its port is taken
   */
  public static DemoMaster open(RosOptions options, ThreadFactory threads) throws IOException {
    if (options.realMaster().isPresent()) {
      return new DemoMaster(Optional.empty(), options.realMaster().get());
    }
    RosMaster master = RosMaster.open(MasterOptions.standard(threads).withPort(options.port()));
    return new DemoMaster(Optional.of(master), master.uri());
  }

  /** What a node at it starts with: at a real one also what this process was told of its network. */
  public RosEnvironment environment(List<String> arguments) {
    Map<String, String> variables = new HashMap<>(own.isPresent() ? Map.of() : System.getenv());
    variables.put("ROS_MASTER_URI", uri.toString());
    return RosEnvironment.of(variables, arguments);
  }

  /** Where it listens. */
  public URI uri() {
    return uri;
  }

  /** The same as users write it, without a slash at its end. */
  public String text() {
    return uri.toString().replaceAll("/$", "");
  }

  @Override
  public void close() {
    own.ifPresent(RosMaster::close);
  }
}
