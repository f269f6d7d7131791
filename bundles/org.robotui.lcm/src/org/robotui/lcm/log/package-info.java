/**
 * LCM's event logs: read ({@link org.robotui.lcm.log.EventLogReader}), indexed
 * ({@link org.robotui.lcm.log.EventLogIndex}) and written ({@link org.robotui.lcm.log.EventLogWriter}).
 *
 * <p>Source: "LCM Log File format" in LCM's documentation.
 */
package org.robotui.lcm.log;
