/** A control in real time: its plugins, and how well their threads keep their time. */
@org.osgi.annotation.versioning.Version("1.2.0")
package org.robotui.data.control;
