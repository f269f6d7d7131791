package org.robotui.ros.internal.master;

import java.util.Optional;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.XmlRpcValue.Text;
import org.robotui.ros.internal.xmlrpc.ApiMethods;
import org.robotui.ros.internal.xmlrpc.ApiMethods.Arguments;
import org.robotui.ros.internal.xmlrpc.XmlRpcFault;

/** The parameter server's API. */
final class ParameterApi {

  private static final XmlRpcValue NOTHING = XmlRpcValue.of(0);
  /** Trees are walked recursively: no name may lead deeper than the stack. */
  private static final int MAX_DEPTH = 64;
  private static final int MAX_KEY = 4096;

  private final Registry registry;
  private ParameterTree tree = ParameterTree.empty();

  ParameterApi(Registry registry) {
    this.registry = registry;
  }

  void addTo(ApiMethods methods) {
    methods.add("setParam", this::set, Text.class, XmlRpcValue.class)
        .add("getParam", this::get, Text.class)
        .add("deleteParam", this::delete, Text.class)
        .add("hasParam", this::has, Text.class)
        .add("searchParam", this::search, Text.class)
        .add("getParamNames", this::names)
        .add("subscribeParam", this::subscribe, Text.class, Text.class)
        .add("unsubscribeParam", this::unsubscribe, Text.class, Text.class);
  }

  /** Sets a parameter on the master's own behalf. */
  synchronized void set(String key, XmlRpcValue value) {
    tree = tree.set(key, value);
  }

  private static String key(Arguments call, int index) throws XmlRpcFault {
    String key = MasterNames.resolve(call.caller(), call.text(index));
    if (key.length() > MAX_KEY || key.chars().filter(c -> c == '/').count() > MAX_DEPTH) {
      throw new XmlRpcFault(-32602,
          "a parameter's name of " + key.length() + " characters, or in more than " + MAX_DEPTH + " namespaces");
    }
    return key;
  }

  private synchronized XmlRpcValue set(Arguments call) throws XmlRpcFault {
    String key = key(call, 1);
    try {
      tree = tree.set(key, call.value(2));
    } catch (IllegalArgumentException e) {
      return ApiMethods.error(e.getMessage(), NOTHING);
    }
    registry.parameterChanged(key, call.value(2), tree, call.caller());
    return ApiMethods.success("parameter " + key + " set", 0);
  }

  private synchronized XmlRpcValue get(Arguments call) throws XmlRpcFault {
    String key = key(call, 1);
    return tree.get(key).map(value -> ApiMethods.success("Parameter [" + key + "]", value)).orElseGet(() -> unset(key));
  }

  private static XmlRpcValue unset(String key) {
    return ApiMethods.error("Parameter [" + key + "] is not set", NOTHING);
  }

  private synchronized XmlRpcValue delete(Arguments call) throws XmlRpcFault {
    String key = key(call, 1);
    Optional<ParameterTree> without = tree.delete(key);
    if (without.isEmpty()) {
      return unset(key);
    }
    tree = without.get();
    registry.parameterChanged(key, ParameterTree.EMPTY, tree, "");
    return ApiMethods.success("parameter " + key + " deleted", 0);
  }

  private synchronized XmlRpcValue has(Arguments call) throws XmlRpcFault {
    String key = key(call, 1);
    return ApiMethods.success(key, XmlRpcValue.of(tree.get(key).isPresent()));
  }

  private synchronized XmlRpcValue search(Arguments call) {
    String key = call.text(1);
    if (key.isEmpty() || key.startsWith("~")) {
      return ApiMethods.error("'" + key + "' cannot be searched for", XmlRpcValue.of(""));
    }
    return tree.search(MasterNames.resolve("/", call.caller()), key)
        .map(found -> ApiMethods.success("Found [" + found + "]", XmlRpcValue.of(found)))
        .orElseGet(
            () -> ApiMethods.error("Cannot find parameter [" + key + "] in an upwards search", XmlRpcValue.of("")));
  }

  private synchronized XmlRpcValue names(Arguments call) {
    return ApiMethods.success("Parameter names", XmlRpcValue.ofTexts(tree.names()));
  }

  private synchronized XmlRpcValue subscribe(Arguments call) throws XmlRpcFault {
    String key = key(call, 2);
    registry.addWatcher(MasterNames.resolve("/", call.caller()), call.text(1), key);
    return ApiMethods.success("Subscribed to parameter [" + key + "]", tree.get(key).orElse(ParameterTree.EMPTY));
  }

  private XmlRpcValue unsubscribe(Arguments call) throws XmlRpcFault {
    String key = key(call, 2);
    boolean removed = registry.removeWatcher(MasterNames.resolve("/", call.caller()), call.text(1), key);
    return ApiMethods.success("Unsubscribed from parameter [" + key + "]", removed ? 1 : 0);
  }
}
