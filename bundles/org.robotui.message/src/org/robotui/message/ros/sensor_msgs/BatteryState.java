package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * State of a battery ({@code sensor_msgs/BatteryState}).
 *
 * @param header time
 * @param voltage volts
 * @param temperature degrees Celsius, NaN if not measured
 * @param current amperes, negative while discharging, NaN if not measured
 * @param charge ampere hours now, NaN if not measured
 * @param capacity ampere hours at the last full charge, NaN if not measured
 * @param designCapacity ampere hours by design, NaN if not known
 * @param percentage 0 to 1, NaN if not measured
 * @param powerSupplyStatus one of the constants {@code POWER_SUPPLY_STATUS_...}
 * @param powerSupplyHealth one of the constants {@code POWER_SUPPLY_HEALTH_...}
 * @param powerSupplyTechnology one of the constants {@code POWER_SUPPLY_TECHNOLOGY_...}
 * @param present whether a battery is there
 * @param cellVoltage volts of each cell, or empty
 * @param cellTemperature degrees Celsius of each cell, or empty
 * @param location where the battery sits
 * @param serialNumber the battery's serial number
 */
@MessageType("sensor_msgs/BatteryState")
public record BatteryState(
    Header header, float voltage, float temperature, float current, float charge, float capacity, float designCapacity,
    float percentage, int powerSupplyStatus, int powerSupplyHealth, int powerSupplyTechnology,
    boolean present, float[] cellVoltage, float[] cellTemperature, String location, String serialNumber) {

  /** The constant {@code POWER_SUPPLY_STATUS_UNKNOWN} of the definition. */
  public static final int POWER_SUPPLY_STATUS_UNKNOWN = 0;
  /** The constant {@code POWER_SUPPLY_STATUS_CHARGING} of the definition. */
  public static final int POWER_SUPPLY_STATUS_CHARGING = 1;
  /** The constant {@code POWER_SUPPLY_STATUS_DISCHARGING} of the definition. */
  public static final int POWER_SUPPLY_STATUS_DISCHARGING = 2;
  /** The constant {@code POWER_SUPPLY_STATUS_NOT_CHARGING} of the definition. */
  public static final int POWER_SUPPLY_STATUS_NOT_CHARGING = 3;
  /** The constant {@code POWER_SUPPLY_STATUS_FULL} of the definition. */
  public static final int POWER_SUPPLY_STATUS_FULL = 4;
  /** The constant {@code POWER_SUPPLY_HEALTH_UNKNOWN} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_UNKNOWN = 0;
  /** The constant {@code POWER_SUPPLY_HEALTH_GOOD} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_GOOD = 1;
  /** The constant {@code POWER_SUPPLY_HEALTH_OVERHEAT} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_OVERHEAT = 2;
  /** The constant {@code POWER_SUPPLY_HEALTH_DEAD} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_DEAD = 3;
  /** The constant {@code POWER_SUPPLY_HEALTH_OVERVOLTAGE} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_OVERVOLTAGE = 4;
  /** The constant {@code POWER_SUPPLY_HEALTH_UNSPEC_FAILURE} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_UNSPEC_FAILURE = 5;
  /** The constant {@code POWER_SUPPLY_HEALTH_COLD} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_COLD = 6;
  /** The constant {@code POWER_SUPPLY_HEALTH_WATCHDOG_TIMER_EXPIRE} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_WATCHDOG_TIMER_EXPIRE = 7;
  /** The constant {@code POWER_SUPPLY_HEALTH_SAFETY_TIMER_EXPIRE} of the definition. */
  public static final int POWER_SUPPLY_HEALTH_SAFETY_TIMER_EXPIRE = 8;
  /** The constant {@code POWER_SUPPLY_TECHNOLOGY_UNKNOWN} of the definition. */
  public static final int POWER_SUPPLY_TECHNOLOGY_UNKNOWN = 0;
  /** The constant {@code POWER_SUPPLY_TECHNOLOGY_NIMH} of the definition. */
  public static final int POWER_SUPPLY_TECHNOLOGY_NIMH = 1;
  /** The constant {@code POWER_SUPPLY_TECHNOLOGY_LION} of the definition. */
  public static final int POWER_SUPPLY_TECHNOLOGY_LION = 2;
  /** The constant {@code POWER_SUPPLY_TECHNOLOGY_LIPO} of the definition. */
  public static final int POWER_SUPPLY_TECHNOLOGY_LIPO = 3;
  /** The constant {@code POWER_SUPPLY_TECHNOLOGY_LIFE} of the definition. */
  public static final int POWER_SUPPLY_TECHNOLOGY_LIFE = 4;
  /** The constant {@code POWER_SUPPLY_TECHNOLOGY_NICD} of the definition. */
  public static final int POWER_SUPPLY_TECHNOLOGY_NICD = 5;
  /** The constant {@code POWER_SUPPLY_TECHNOLOGY_LIMN} of the definition. */
  public static final int POWER_SUPPLY_TECHNOLOGY_LIMN = 6;
}
