/** What robots are told: motions with their limits, single messages on any topic, and what other robots say. */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.data.command;
