package org.robotui.ros.internal.master;

import java.io.IOException;
import java.net.URI;
import java.util.Optional;
import java.util.UUID;
import org.robotui.net.thread.Workers;
import org.robotui.ros.RosNode;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.node.LocalAddress;
import org.robotui.ros.internal.xmlrpc.ApiMethods;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.ros.internal.xmlrpc.XmlRpcServer;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;

/** A running master. */
public final class MasterRuntime implements RosMaster {

  private static final long JOIN_NANOS = 900_000_000;

  private final Workers workers;
  private final Notifier notifier;
  private final XmlRpcServer server;
  private final URI uri;
  private final Optional<RosNode> rosout;

  private MasterRuntime(MasterOptions options) throws IOException {
    workers = new Workers(options.threads());
    notifier = new Notifier(workers);
    LocalAddress address = LocalAddress.of(options.host());
    server = new XmlRpcServer(address.bind(), options.port(), XmlRpcLimits.standard(), workers, "ros master");
    uri = URI.create(address.uri("http", server.port()) + "/");
    server.start(methods());
    rosout = options.rosout() ? Optional.of(openRosout(options)) : Optional.empty();
  }

  /** Starts a master. */
  public static RosMaster open(MasterOptions options) throws IOException {
    return new MasterRuntime(options);
  }

  private ApiMethods methods() {
    Registry registry = new Registry(notifier);
    ParameterApi parameters = new ParameterApi(registry);
    parameters.set("/run_id", XmlRpcValue.of(UUID.randomUUID().toString()));
    parameters.set("/rosdistro", XmlRpcValue.of("noetic\n"));
    parameters.set("/rosversion", XmlRpcValue.of("1.16.0\n"));
    ApiMethods methods = new ApiMethods();
    new MasterApi(registry, uri.toString()).addTo(methods);
    parameters.addTo(methods);
    return methods;
  }

  private RosNode openRosout(MasterOptions options) throws IOException {
    try {
      return Rosout.open(uri, options.host(), options.threads());
    } catch (IOException e) {
      server.close();
      throw e;
    }
  }

  @Override
  public URI uri() {
    return uri;
  }

  @Override
  public void close() {
    rosout.ifPresent(RosNode::close);
    server.close();
    notifier.close();
    workers.join(System.nanoTime() + JOIN_NANOS);
  }
}
