/** What robots are told: motions with their limits, and single messages on any topic. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.data.command;
