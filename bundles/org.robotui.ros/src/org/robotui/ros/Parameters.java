package org.robotui.ros;

import java.util.List;
import org.robotui.net.call.Outcome;

/** The master's parameter server. All names are resolved as seen from the node. Calls wait for the master. */
public interface Parameters {

  /**
   * Reads a parameter or a whole namespace.
   *
   * @param name the parameter
   * @return its value, a {@link XmlRpcValue.Struct} for a namespace; refused if it is not set
   */
  Outcome<XmlRpcValue> get(String name);

  /**
   * Sets a parameter; a struct replaces a whole namespace.
   *
   * @param name the parameter
   * @param value its new value
   * @return done, or why not
   */
  Outcome<Boolean> set(String name, XmlRpcValue value);

  /**
   * Deletes a parameter or a whole namespace.
   *
   * @param name the parameter
   * @return done, or refused if it is not set
   */
  Outcome<Boolean> delete(String name);

  /**
   * Whether a parameter is set.
   *
   * @param name the parameter
   * @return true if it is
   */
  Outcome<Boolean> has(String name);

  /**
   * Looks for a parameter in the node's namespace and those above it.
   *
   * @param name a relative name
   * @return the global name of the nearest one; refused if there is none
   */
  Outcome<String> search(String name);

  /**
   * All parameters.
   *
   * @return their global names
   */
  Outcome<List<String>> names();

  /**
   * Listens to a parameter, from now on and across restarts of the master.
   *
   * @param name the parameter or namespace
   * @param listener hears of its value
   * @return closing it ends the subscription
   */
  AutoCloseable subscribe(String name, ParameterListener listener);
}
