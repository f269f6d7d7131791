/**
 * Alerts: what a view noticed about a robot that somebody should see, and what users do with that.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.alert;
