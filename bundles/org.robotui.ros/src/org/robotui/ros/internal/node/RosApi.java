package org.robotui.ros.internal.node;

import java.io.Closeable;
import java.io.IOException;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.MethodCall;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcFault;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;

/** Calls the API of a master or a node, whose answers are all {@code [code, status, value]}. */
final class RosApi implements Closeable {

  private final XmlRpcClient client;
  /** What error messages start with. */
  private final String prefix;
  private final Duration timeout;

  /** An api whose errors name the peer, unless it is empty because the caller says it. */
  RosApi(HostPort target, String peer, Duration timeout) {
    this.client = new XmlRpcClient(target, XmlRpcLimits.standard().withMessage(timeout));
    this.prefix = peer.isEmpty() ? "" : peer + " at " + target + ": ";
    this.timeout = timeout;
  }

  Outcome<XmlRpcValue> call(String method, XmlRpcValue... arguments) {
    return call(timeout, method, arguments);
  }

  Outcome<XmlRpcValue> call(MethodCall call) {
    return call(call.method(), call.arguments().toArray(XmlRpcValue[]::new));
  }

  /**
   * Makes several calls in one request; answers how many were answered, whatever the answers say. A peer may not know
   * how.
   */
  Outcome<Integer> callAll(List<MethodCall> calls) {
    XmlRpcValue all = new XmlRpcValue.Array(calls.stream().<XmlRpcValue>map(call -> new XmlRpcValue.Struct(
        Map.of("methodName", XmlRpcValue.of(call.method()), "params", new XmlRpcValue.Array(call.arguments()))))
        .toList());
    try {
      return client.call("system.multicall", List.of(all), timeout) instanceof XmlRpcValue.Array answers
          && answers.items().size() == calls.size()
          && answers.items().stream().allMatch(XmlRpcValue.Array.class::isInstance)
              ? new Outcome.Done<>(calls.size())
              : new Outcome.Failed<>(prefix + "system.multicall did not answer all calls");
    } catch (SocketTimeoutException e) {
      return new Outcome.TimedOut<>(prefix + e.getMessage(), timeout);
    } catch (IOException | XmlRpcFault e) {
      return new Outcome.Failed<>(prefix + PeerText.brief(String.valueOf(e.getMessage())));
    }
  }

  /** The request that this call would be, on a connection of its own. */
  byte[] words(MethodCall call) {
    return client.words(call);
  }

  /** Whom it calls. */
  HostPort target() {
    return client.target();
  }

  Outcome<XmlRpcValue> call(Duration within, String method, XmlRpcValue... arguments) {
    try {
      return answer(method, client.call(method, List.of(arguments), within));
    } catch (SocketTimeoutException e) {
      return new Outcome.TimedOut<>(prefix + e.getMessage(), within);
    } catch (IOException | XmlRpcFault e) {
      return new Outcome.Failed<>(prefix + PeerText.brief(String.valueOf(e.getMessage())));
    }
  }

  private Outcome<XmlRpcValue> answer(String method, XmlRpcValue value) {
    if (value instanceof XmlRpcValue.Array array && array.items().size() >= 3
        && array.items().get(0) instanceof XmlRpcValue.Int code
        && array.items().get(1) instanceof XmlRpcValue.Text status) {
      return code.value() == 1 ? new Outcome.Done<>(array.items().get(2))
          : new Outcome.Refused<>(PeerText.brief(status.value()));
    }
    return new Outcome.Failed<>(prefix + method + " did not answer [code, status, value]");
  }

  @Override
  public void close() {
    client.close();
  }
}
