package org.robotui.rfic.lcm.internal.language;

import org.robotui.api.config.SettingFault;

/** A part of the configuration that does not fit. */
public final class FaultException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient SettingFault fault;

  /** With what is wrong and where. */
  public FaultException(SettingFault fault) {
    super(fault.toString());
    this.fault = fault;
  }

  /** What is wrong and where. */
  public SettingFault fault() {
    return fault;
  }
}
