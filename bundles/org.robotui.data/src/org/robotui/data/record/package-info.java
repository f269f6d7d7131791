/** Any value as a record with named fields, read by paths; and what the fields of data types mean. */
@org.osgi.annotation.versioning.Version("1.4.0")
package org.robotui.data.record;
