package org.robotui.smartsoft.client;

/** How often an activated event may happen. The order is that of the numbers on the wire. */
public enum EventMode {
  /** Once. */
  SINGLE,
  /** Again and again. */
  CONTINUOUS
}
