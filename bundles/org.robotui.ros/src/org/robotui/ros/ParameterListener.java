package org.robotui.ros;

import java.util.Optional;

/** Hears of changes of a parameter. */
@FunctionalInterface
public interface ParameterListener {

  /**
   * The parameter, or one below it, was set or deleted. Called once with the present value after the subscription, and
   * again after the master came back. Called on an I/O thread; must not block.
   *
   * @param key the parameter that changed: the one subscribed to, or one below it
   * @param value its new value; empty if it is not set
   */
  void onParameter(GraphName key, Optional<XmlRpcValue> value);
}
