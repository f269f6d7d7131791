/**
 * What sensors measure: ranges, points, contacts, positions by satellite, acceleration, and the charge of a battery.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.data.sensor;
