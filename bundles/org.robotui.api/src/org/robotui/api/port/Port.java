package org.robotui.api.port;

/** A named, typed place where a component is connected. */
public sealed interface Port permits StreamPort, CommandPort, CallPort, BrowsePort {
  /**
   * The name, unique within the component and kind; a robot interface may use the robot's own names ({@code /scan}).
   *
   * @return the name
   */
  String name();

  /**
   * How many connections it takes, on the side of a view.
   *
   * @return the arity
   */
  Arity arity();

  /**
   * A sentence for users.
   *
   * @return what it is for
   */
  String help();

  /**
   * What passes through.
   *
   * @return the kind
   */
  PortKind kind();

  /**
   * The type as users read it, for example {@code LaserScan} or {@code ServiceRequest -> ServiceReply}.
   *
   * @return the name of the type
   */
  String typeName();
}
