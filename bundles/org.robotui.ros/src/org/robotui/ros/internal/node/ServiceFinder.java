package org.robotui.ros.internal.node;

import java.io.IOException;
import java.net.SocketTimeoutException;
import java.time.Duration;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.GraphName;
import org.robotui.ros.ServiceIdentity;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.ProtocolException;

/** Finds servers of services by the master and asks them who they are. */
record ServiceFinder(NodeContext context, RosApi master, CloseableSet sockets) {

  HostPort find(GraphName service, Deadline deadline) throws IOException {
    Outcome<XmlRpcValue> outcome = master.call(deadline.left(), "lookupService", XmlRpcValue.of(context.name().text()),
        XmlRpcValue.of(service.text()));
    return switch (outcome) {
      case Outcome.Done<XmlRpcValue>(XmlRpcValue.Text uri) -> parse(uri.value());
      case Outcome.Done<XmlRpcValue> other -> throw new ProtocolException("the master's lookupService answered no URI");
      case Outcome.TimedOut<XmlRpcValue> late -> throw new SocketTimeoutException(late.reason());
      default -> throw new IOException(outcome.reason());
    };
  }

  private static HostPort parse(String uri) throws IOException {
    try {
      return HostPort.ofUri(uri, "rosrpc");
    } catch (IllegalArgumentException e) {
      throw new ProtocolException(e.getMessage(), e);
    }
  }

  Outcome<ServiceIdentity> probe(GraphName service, Duration timeout) {
    Deadline deadline = Deadline.in(timeout);
    ConnectionHeader request = ConnectionHeader.of(context.name().text()).with("service", service.text())
        .with("md5sum", "*").with("probe", "1");
    try (ServiceLink link = new ServiceLink(context, sockets)) {
      link.open(find(service, deadline), request, deadline);
      return new Outcome.Done<>(identity(link.header()));
    } catch (SocketTimeoutException e) {
      return new Outcome.TimedOut<>("service " + service + " did not answer in time", timeout);
    } catch (IOException e) {
      return new Outcome.Failed<>("service " + service + ": " + e.getMessage());
    }
  }

  private static ServiceIdentity identity(ConnectionHeader header) throws ProtocolException {
    return new ServiceIdentity(header.require("type"), header.require("md5sum"),
        header.field("request_type").orElse(""),
        header.field("response_type").orElse(""), header.field("callerid").orElse(""));
  }
}
