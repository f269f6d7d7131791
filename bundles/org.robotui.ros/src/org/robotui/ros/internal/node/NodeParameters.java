package org.robotui.ros.internal.node;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.NameResolver;
import org.robotui.ros.ParameterListener;
import org.robotui.ros.Parameters;
import org.robotui.ros.XmlRpcValue;

/** The parameter server as one node sees it. */
final class NodeParameters implements Parameters {

  private final NameResolver names;
  private final RosApi master;
  private final Registrar registrar;
  private final String uri;
  private final RecordFile record;
  private final List<WatchedParameter> watched = new CopyOnWriteArrayList<>();

  NodeParameters(NameResolver names, RosApi master, Registrar registrar, String uri, RecordFile record) {
    this.names = names;
    this.master = master;
    this.registrar = registrar;
    this.uri = uri;
    this.record = record;
  }

  @Override
  public Outcome<XmlRpcValue> get(String name) {
    return call("getParam", key(name));
  }

  @Override
  public Outcome<Boolean> set(String name, XmlRpcValue value) {
    Outcome<Boolean> outcome = call("setParam", key(name), value).map(done -> true);
    if (outcome instanceof Outcome.Done) {
      updated(names.resolve(name), value);
    }
    return outcome;
  }

  @Override
  public Outcome<Boolean> delete(String name) {
    return call("deleteParam", key(name)).map(done -> true);
  }

  @Override
  public Outcome<Boolean> has(String name) {
    return call("hasParam", key(name)).map(answer -> answer.equals(XmlRpcValue.of(true)));
  }

  @Override
  public Outcome<String> search(String name) {
    return call("searchParam", XmlRpcValue.of(name))
        .map(answer -> answer instanceof XmlRpcValue.Text text ? text.value() : "");
  }

  @Override
  public Outcome<List<String>> names() {
    return call("getParamNames").map(GraphCodec::texts);
  }

  @Override
  public AutoCloseable subscribe(String name, ParameterListener listener) {
    WatchedParameter parameter = new WatchedParameter(names.node(), names.resolve(name), uri, listener);
    record.parameter(parameter.key().text());
    watched.add(parameter);
    registrar.add(parameter);
    return () -> unsubscribe(parameter);
  }

  private void unsubscribe(WatchedParameter parameter) {
    watched.remove(parameter);
    boolean last = watched.stream().noneMatch(other -> other.key().equals(parameter.key()));
    if (last) {
      registrar.remove(parameter);
    } else {
      registrar.forget(parameter);
    }
  }

  /** The master told of a change, or we made it: masters do not tell the one who did. */
  void updated(GraphName key, XmlRpcValue value) {
    for (WatchedParameter parameter : watched) {
      if (parameter.key().contains(key)) {
        parameter.deliver(key, value);
      } else if (key.contains(parameter.key())) {
        parameter.deliver(parameter.key(), below(key, parameter.key(), value));
      }
    }
  }

  /** The part of a namespace's value that one parameter in it has. */
  private static XmlRpcValue below(GraphName namespace, GraphName key, XmlRpcValue value) {
    XmlRpcValue part = value;
    for (String step : key.text().substring(namespace.text().length()).split("/")) {
      if (!step.isEmpty()) {
        part = part instanceof XmlRpcValue.Struct struct
            ? struct.members().getOrDefault(step, WatchedParameter.UNSET)
            : WatchedParameter.UNSET;
      }
    }
    return part;
  }

  private XmlRpcValue key(String name) {
    return XmlRpcValue.of(names.resolve(name).text());
  }

  private Outcome<XmlRpcValue> call(String method, XmlRpcValue... arguments) {
    XmlRpcValue[] all = new XmlRpcValue[arguments.length + 1];
    all[0] = XmlRpcValue.of(names.node().text());
    System.arraycopy(arguments, 0, all, 1, arguments.length);
    return master.call(method, all);
  }
}
