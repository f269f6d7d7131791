package org.robotui.smartsoft.wire;

/** Numbers of what is said to a naming service and by it, which are those of ACE. */
public final class NamingCommand {

  /** Enters a name with a value and a type; also what answers most requests. */
  public static final int BIND = 1;
  /** Enters a name in place of what it stood for. */
  public static final int REBIND = 2;
  /** Asks for a name, and answers with its entry. */
  public static final int RESOLVE = 3;
  /** Removes a name. */
  public static final int UNBIND = 4;
  /** Ends a list. */
  public static final int END_OF_LIST = 11;
  /** Asks for all entries whose types begin with a text, and answers with each of them. */
  public static final int LIST = 22;

  private NamingCommand() {}
}
